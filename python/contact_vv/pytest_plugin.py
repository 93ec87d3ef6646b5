"""Prints the table below a failed `assert contact_vv.judge("cylinder", s, p)`, or `assert all(verdicts)`, of a test."""

from __future__ import annotations

from collections.abc import Generator
from typing import Any

import pytest

from . import Verdicts


@pytest.hookimpl(tryfirst=True)
def pytest_runtest_setup() -> None:
    """Forgets what another test asked."""
    Verdicts.refused = None


@pytest.hookimpl(hookwrapper=True)
def pytest_runtest_makereport(call: pytest.CallInfo[None]) -> Generator[None, Any, None]:
    """Looks for verdicts among the local variables of a failed test, where pytest keeps parts of an assertion, and for those asked last."""
    refused = Verdicts.refused  # which the next line asks anew
    outcome = yield
    if call.excinfo is None:
        return
    found = [*call.excinfo.traceback[-1].frame.f_locals.values()]
    if refused is not None and call.excinfo.errisinstance(AssertionError):
        found.append(refused)
    different = {id(one): one for one in found if issubclass(type(one), Verdicts) and not one}
    outcome.get_result().sections.extend(("contact-vv", repr(one)) for one in different.values())
