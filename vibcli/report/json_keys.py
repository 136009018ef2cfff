"""All keys of --json: what each means. Dots lead into objects, [] into lists."""

from vibcli.analyses import OF_MODES
from vibcli.report.keys import Key, documented
from vibcli.report.section_keys import section_keys
from vibcli.report.sections.accelerations import ACCELERATIONS
from vibcli.report.sections.backbone import KEY as BACKBONE
from vibcli.report.sections.certified import CERTIFICATE
from vibcli.report.sections.design_parameters import CHOSEN
from vibcli.report.sections.equations_of_motion import ENERGY, EQUATIONS, MATRICES
from vibcli.report.sections.equilibria import EQUILIBRIA, SEARCH
from vibcli.report.sections.equilibrium import EQUILIBRIUM, STICKING
from vibcli.report.sections.equivalents import KEY as EQUIVALENTS
from vibcli.report.sections.expansion import KEY as EXPANSION
from vibcli.report.sections.frequency_response import FREQUENCY_RESPONSE
from vibcli.report.sections.member_modes import COUNT, MEMBERS
from vibcli.report.sections.motion_data import MOTION
from vibcli.report.sections.phase_plane import KEY as PHASE_PLANE
from vibcli.report.sections.spectrum_data import DAMPED_MODES, MODES, POLYNOMIAL
from vibcli.report.sections.statics import REACTIONS
from vibcli.report.sections.steps import KEY as STEPS
from vibcli.report.sections.sweep import KEY as SWEEP
from vibcli.report.sections.variants import KEY as VARIANTS

ABOUT = ("What `vibcli solve`, `frequencies`, `equations`, `response`, `frf`, `sweep` and `variants` print with "
         "--json: one object in SI units, angles in radians, null where there is nothing. Values are strings where the "
         "scene has symbols without value (expressions of the scene language) or with --digits (decimals); else "
         "numbers.")
KEYS = dict(documented((
    Key("title", "the title of the scene, or null"),
    Key("coordinates", "names of the generalised coordinates, in the order of all rows and columns"),
    CHOSEN, EQUILIBRIUM, EQUILIBRIA, SEARCH, STICKING, ENERGY, EQUATIONS, MATRICES, REACTIONS, ACCELERATIONS,
    Key("remark", "why a scene in letters, or one with a kink at rest, has no equilibrium, matrices and modes here, or "
        "one without inertia no modes, in words; absent otherwise"),
    MODES._replace(each=(*MODES.each, MEMBERS)), COUNT, DAMPED_MODES, MOTION, FREQUENCY_RESPONSE,
    EQUIVALENTS, BACKBONE, EXPANSION, PHASE_PLANE, SWEEP, VARIANTS, STEPS, CERTIFICATE,
    Key("insight", "only where `find` or --insight asks for it", of=section_keys(OF_MODES)), POLYNOMIAL,
    Key("cases", "{name: the same keys}, where the file has cases"))))
