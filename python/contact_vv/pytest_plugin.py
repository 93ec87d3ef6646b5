"""Prints the table below a failed `assert contact_vv.judge("cylinder", s, p)` of a test."""

from __future__ import annotations

from collections.abc import Generator
from typing import Any

import pytest

from . import Verdicts


@pytest.hookimpl(hookwrapper=True)
def pytest_runtest_makereport(call: pytest.CallInfo[None]) -> Generator[None, Any, None]:
    """Looks for verdicts among the local variables of a failed test: pytest keeps parts of an assertion there."""
    outcome = yield
    found = call.excinfo.traceback[-1].frame.f_locals.values() if call.excinfo is not None else []
    tables = [("contact-vv", repr(one)) for one in found if issubclass(type(one), Verdicts) and not one]
    outcome.get_result().sections.extend(tables)
