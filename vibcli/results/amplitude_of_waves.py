"""The amplitude of a sum of waves in numbers, as that of the signal which they are."""

from typing import TYPE_CHECKING

from vibcli.analyses.continuous.kept_up_motion import Harmonic, KeptUpMotion
from vibcli.analyses.excitation.linear_output import LinearOutput
from vibcli.results.signals import LinearSignal
from vibcli.results.steady_features import amplitude

if TYPE_CHECKING:
    from collections.abc import Mapping

    from vibcli.base.work import Work


def amplitude_of_waves(waves: "Mapping[float, complex]", work: "Work | None") -> float:
    """Half the range of Σ Re(X e^{iΩt}), {Ω: X}."""
    kept = KeptUpMotion(1, [Harmonic(0, Omega, complex(X), 0.0) for Omega, X in waves.items()], work)
    return amplitude(LinearSignal(kept, LinearOutput(0.0, channels={0: 1.0})))
