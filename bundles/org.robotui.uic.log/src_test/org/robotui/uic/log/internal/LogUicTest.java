package org.robotui.uic.log.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.robotui.api.port.InputState;
import org.robotui.data.status.LogEntry;
import org.robotui.data.status.Severity;
import org.robotui.testkit.FakeUicContext;
import org.robotui.ui.ViewAction;
import org.robotui.uic.log.internal.model.LogFilter;
import org.robotui.uic.log.internal.model.Search;

class LogUicTest {
  private final FakeUicContext context = new FakeUicContext("log", new LogType().schema());

  @Test
  void theTickTellsWhetherThereIsSomethingNew() {
    LogUic uic = new LogUic(context);
    assertFalse(uic.tick(0));
    context.input(LogType.LOG).put(new LogEntry(Severity.INFO, "/node", "hello", ""));
    assertTrue(uic.tick(1));
    assertFalse(uic.tick(2));
    context.input(LogType.LOG).state(new InputState.Stale(1, "the link is lost"));
    assertTrue(uic.tick(3), "a lost link is news");
  }

  @Test
  void theFilterIsKeptAsSettingsAndComesBack() {
    LogFilter filter =
        LogFilter.ALL.level(Severity.DEBUG, false).onlyOrigin("/a").search(Search.of("x+", true)).collapse(true);
    LogPreferences.write(context.settings(), filter);
    assertEquals(filter, LogPreferences.read(context.settings().current()));
    assertEquals(List.of("info", "warning", "error", "fatal"), context.settings().current().list(LogType.LEVELS));
  }

  @Test
  void withoutSettingsAllIsShown() {
    assertEquals(LogFilter.ALL, LogPreferences.read(context.settings().current()));
    assertEquals(Set.of(), LogFilter.ALL.hidden());
  }

  @Test
  void pausingAndCollapsingAreActionsThatShowWhetherTheyAreOn() {
    LogUic uic = new LogUic(context);
    for (String id : List.of("pause", "collapse")) {
      ViewAction action = uic.actions().stream().filter(a -> a.id().equals(id)).findFirst().orElseThrow();
      assertFalse(action.checked().orElseThrow().getAsBoolean());
      action.run().run();
      assertTrue(action.checked().orElseThrow().getAsBoolean());
    }
    assertTrue(context.settings().current().flag(LogType.COLLAPSE));
  }
}
