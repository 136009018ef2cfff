"""One meaning a name, and no name that nothing uses."""


def test_a_public_class_has_a_name_of_its_own(house):
    assert house.class_names() == {}


def test_what_is_defined_is_used_by_the_program(house):
    assert sorted(house.unused()) == []


def test_what_only_something_unused_uses_is_seen(planted):
    house = planted({
        "scene/a.py": "LEFT = 1\n\n\ndef outer():\n    return inner()\n\n\ndef inner():\n    return outer()\n",
        "scene/b.py": "import click\n\nfrom vibcli.scene import c\n\n\nclass Kind(click.Group):\n"
                      "    def called_by_click(self):\n        return c.used().taken()\n\n\nprint(Kind)\n",
        "scene/c.py": "def used():\n    return Value()\n\n\ndef taken():\n    pass\n\n\nclass Value:\n"
                      "    def taken(self):\n        return getattr(self, 'in_' + 'time')\n\n    def in_time(self):\n"
                      "        pass\n\n    def left(self):\n        pass\n"})
    assert sorted(house.unused()) == [("vibcli.scene.a", "LEFT"), ("vibcli.scene.a", "inner"),
                                      ("vibcli.scene.a", "outer"), ("vibcli.scene.c", "Value.left"),
                                      ("vibcli.scene.c", "taken")]
