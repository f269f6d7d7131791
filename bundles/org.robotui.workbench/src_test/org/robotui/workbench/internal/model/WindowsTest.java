package org.robotui.workbench.internal.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.testkit.host.FakeHost;
import org.robotui.testkit.host.FakeRuic;

class WindowsTest {
  private final FakeRuic keira = new FakeRuic("Keira");
  private final FakeRuic natalie = new FakeRuic("Natalie");
  private final FakeHost host = new FakeHost().add(keira).add(natalie);
  private final Windows windows = new Windows(host);

  @Test
  void aNewWindowShowsWhatNoOtherShows() {
    WindowModel first = windows.open();
    WindowModel second = windows.open();
    WindowModel third = windows.open();

    assertEquals(Optional.of(keira), first.selected());
    assertEquals(Optional.of(natalie), second.selected());
    assertTrue(third.selected().isEmpty());
  }

  @Test
  void whatTheFilesAskForComesFirst() {
    FakeRuic marvin = new FakeRuic("Marvin");
    host.add(marvin).asking("Marvin", "gone", "Natalie");

    assertEquals(List.of("Marvin", "Natalie"), windows.asked().stream().map(w -> w.ruic()).toList());
    assertEquals(Optional.of(marvin), windows.open().selected());
    assertEquals(Optional.of(natalie), windows.open().selected());
    assertEquals(Optional.of(keira), windows.open().selected(), "of a window more, the first that is left");
  }

  @Test
  void theControlsOfTheFormerGoBeforeTheNextIsSelected() {
    WindowModel window = windows.open();
    List<String> seen = new ArrayList<>();
    window.onChange(
        () -> seen.add(window.selected().map(r -> r.name() + natalie.windows()).orElse("nothing" + natalie.windows())));

    windows.select(window, natalie);

    assertEquals(List.of("nothing[]", "Natalie[" + window.window() + "]"), seen);
  }

  @Test
  void whatATeamOpensIsNotTakenFromTheWindowThatShowsIt() {
    WindowModel first = windows.open();
    WindowModel second = windows.open();
    List<String> fronts = new ArrayList<>();
    second.onFront(() -> fronts.add(second.title()));

    windows.showInstead("Keira", natalie);

    assertEquals(List.of("Natalie - RobotUI"), fronts);
    assertEquals(Optional.of(keira), first.selected());
    assertEquals(Optional.of(second), windows.elsewhere(first, natalie));
    assertEquals(Optional.empty(), windows.elsewhere(second, natalie));
  }

  @Test
  void aRuicIsShownInOneWindowAtATime() {
    WindowModel first = windows.open();
    WindowModel second = windows.open();

    windows.select(second, keira);

    assertTrue(first.selected().isEmpty());
    assertEquals(List.of(second.window()), keira.windows());
  }

  @Test
  void whatWasRemovedIsShownNoMore() {
    WindowModel window = windows.open();
    host.remove(keira);

    windows.ruicsChanged();

    assertTrue(window.selected().isEmpty());
  }

  @Test
  void aClosedWindowUnselects() {
    WindowModel window = windows.open();

    windows.close(window);

    assertEquals(List.of(), keira.windows());
  }

  @Test
  void selectingWhatIsShownChangesNothing() {
    WindowModel window = windows.open();
    int before = keira.calls().size();

    windows.select(window, keira);

    assertEquals(before, keira.calls().size());
  }
}
