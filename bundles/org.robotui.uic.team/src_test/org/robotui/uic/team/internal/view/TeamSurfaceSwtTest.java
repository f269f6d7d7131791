package org.robotui.uic.team.internal.view;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.FillLayout;
import org.eclipse.swt.widgets.Shell;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.robotui.testkit.Displays;
import org.robotui.testkit.FakeAuthority;
import org.robotui.testkit.TestDisplay;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.ui.UiContext;
import org.robotui.uic.team.internal.Squad;
import org.robotui.uic.team.internal.model.TeamCommands;
import org.robotui.uic.team.internal.model.TeamModel;
import org.robotui.uic.team.internal.model.TeamRow;

@EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
class TeamSurfaceSwtTest {
  private final Squad squad = new Squad(12);
  private final TeamModel model = new TeamModel(squad.context, List.of(), "move_base/status");
  private Shell shell;
  private Theme theme;
  private TeamSurface surface;
  private String note = "";

  @BeforeEach
  void open() {
    for (int i = 1; i <= 12; i++) {
      squad.drives(i, i, 0, i % 2);
    }
    theme = Themes.dark(TestDisplay.get());
    shell = new Shell(TestDisplay.get(), SWT.NO_TRIM);
    shell.setLayout(new FillLayout());
    shell.setSize(900, 500);
    surface = new TeamSurface(shell, UiContext.of(theme, n -> note = n), new TeamCommands(squad.context));
    shell.open();
    tick();
  }

  @AfterEach
  void close() {
    shell.dispose();
    theme.dispose();
  }

  private void tick() {
    surface.prepare(model.tick(System.nanoTime()));
    surface.refresh();
  }

  private List<String> selected() {
    return surface.table().list().selected().stream().map(TeamRow::robot).toList();
  }

  private long stopped() {
    return IntStream.rangeClosed(1, 12).filter(i -> squad.robot(i).stoppedBy().isPresent()).count();
  }

  @Test
  void theFilterGoesWhereItIsNarrow() {
    shell.setSize(420, 500);
    tick();
    assertFalse(surface.filterField().getVisible());
    shell.setSize(900, 500);
    tick();
    assertTrue(surface.filterField().getVisible());
  }

  @Test
  void whatIsSelectedElsewhereIsSelectedHereAndTheOtherWayRound() {
    squad.context.ruic().selection().set(Set.of("r2", "r7"));
    tick();
    assertEquals(List.of("r2", "r7"), selected());
    surface.select(Set.of("r3"));
    assertEquals(Set.of("r3"), squad.context.ruic().selection().robots());
    assertEquals(List.of("r3"), selected());
  }

  @Test
  void stopsWhoIsSelectedAndAllWhereNobodyIsWithoutAQuestion() {
    surface.select(Set.of("r2", "r7"));
    surface.bar().stop();
    assertEquals(2, stopped());
    surface.select(Set.of());
    surface.bar().stop();
    assertEquals(12, stopped());
    assertEquals("", surface.bar().question());
    assertEquals("Stopped 12 robots", surface.bar().answer());
  }

  @Test
  void whatConcernsAllIsAskedBefore() {
    surface.bar().stop();
    surface.bar().release();
    assertEquals("Release the stop of all 12 robots?", surface.bar().question());
    assertEquals(12, stopped());
    surface.bar().no();
    assertEquals("", surface.bar().question());
    assertEquals(12, stopped());
    surface.bar().release();
    surface.bar().yes();
    assertEquals(0, stopped());
  }

  @Test
  void aSelectionIsNotAskedUnlessItIsEverybody() {
    surface.select(Set.of("r1"));
    surface.bar().zero();
    assertEquals(Optional.of(FakeAuthority.YOU), squad.robot(1).holder());
    assertEquals(Optional.empty(), squad.robot(2).holder());
    surface.select(squad.context.ruic().authorities().stream().map(a -> a.robot()).collect(Collectors.toSet()));
    surface.bar().zero();
    assertTrue(surface.bar().question().contains("all 12"));
    assertEquals(Optional.empty(), squad.robot(2).holder());
  }

  @Test
  void filtersAndSays() {
    assertEquals("12 robots  \u00b7  6 driving  \u00b7  6 standing", note);
    surface.filterField().words("standing");
    assertEquals(6, surface.table().list().rows().size());
    surface.select(Set.of("r1"));
    surface.bar().stop();
    assertEquals(1, stopped(), "also who is filtered out");
  }
}
