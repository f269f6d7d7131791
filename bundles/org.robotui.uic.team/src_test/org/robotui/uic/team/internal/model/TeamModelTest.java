package org.robotui.uic.team.internal.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.robotui.api.port.InputState;
import org.robotui.testkit.FakeAuthority;
import org.robotui.ui.Figures;
import org.robotui.uic.team.internal.Squad;

class TeamModelTest {
  private static TeamLook look(Squad squad, String... leftOut) {
    return new TeamModel(squad.context, List.of(leftOut), "move_base/status").tick(System.nanoTime());
  }

  private static TeamRow row(Squad squad, int number) {
    return look(squad).rows().get(number - 1);
  }

  @Test
  void eachRobotHasARowInTheOrderOfTheConfiguration() {
    TeamLook look = look(new Squad(12), "r3");
    assertEquals(11, look.rows().size());
    assertEquals(List.of("r1", "r2", "r4"), look.rows().stream().map(TeamRow::robot).limit(3).toList());
    assertEquals("player", look.rows().get(1).framework());
    assertEquals(3, look.rows().get(2).number(), "the colour of r4 does not depend on who is left out");
  }

  @Test
  void saysWhatARobotIsDoing() {
    Squad squad = new Squad(3).drives(1, 1, 2, 0.31).drives(2, 3, 4, 0);
    assertEquals(Activity.DRIVING, row(squad, 1).doing());
    assertTrue(row(squad, 1).state().contains("0.31"), row(squad, 1).state());
    assertEquals(Activity.STANDING, row(squad, 2).doing());
    assertEquals(Activity.WAITING, row(squad, 3).doing());
    assertEquals(3, row(squad, 2).place().orElseThrow().x());
    assertEquals("3 robots  \u00b7  1 waiting  \u00b7  1 driving  \u00b7  1 standing", look(squad).note());
  }

  @Test
  void aStopIsSeenBeforeAllElseButWhatHidesIt() {
    Squad squad = new Squad(3).drives(1, 0, 0, 0.2).drives(2, 0, 0, 0).drives(3, 0, 0, 0).lose(3);
    squad.robot(1).stop(FakeAuthority.ANNA);
    squad.robot(2).stop(FakeAuthority.YOU);
    squad.robot(3).stop(FakeAuthority.YOU);
    assertEquals("stopped, still moving", row(squad, 1).state());
    assertTrue(row(squad, 1).why().startsWith("stopped by Anna"));
    assertEquals("stopped", row(squad, 2).state());
    assertEquals(Activity.LOST, row(squad, 3).doing(), "nobody knows whether the stop came through");
    assertEquals("stopped, no link", row(squad, 3).state());
    assertTrue(row(squad, 3).why().contains("refuses the connection"));
  }

  @Test
  void saysWhyARobotIsSilentWhileOthersGoOn() {
    Squad squad = new Squad(2).drives(1, 0, 0, 0.2).drives(2, 0, 0, 0.2).is(1,
        InputState.Stale.lost(12, "nobody publishes /r1/odom any more", 10));
    assertEquals(Activity.SILENT, row(squad, 1).doing());
    assertEquals("nobody publishes /r1/odom any more", row(squad, 1).why());
    assertEquals(Activity.DRIVING, row(squad, 2).doing());
    squad.is(1, new InputState.Stale(2.1, "older than usual"));
    assertEquals("stale " + Figures.age(2.1), row(squad, 1).state());
  }

  @Test
  void tellsTheTaskThatTheRobotTells() {
    Squad squad = new Squad(4).does(1, 1, "going to 4.0 12.0").does(2, 4, "").does(3, 3, "");
    TeamModel model = new TeamModel(squad.context, List.of(), "move_base/status");
    model.tick(System.nanoTime());
    List<TeamRow> rows = model.tick(System.nanoTime()).rows();
    assertEquals(List.of("going to 4.0 12.0", "failed", "done", ""), rows.stream().map(TeamRow::task).toList());
  }

  @Test
  void theBatteryIsAShareOrAVoltage() {
    assertEquals(Figures.of(87, 0, "%"), row(new Squad(1).charged(1, 0.87), 1).battery());
    assertEquals(Figures.of(24, 1, "V"), row(new Squad(1).charged(1, Double.NaN), 1).battery());
    assertEquals("", row(new Squad(1), 1).battery());
  }

  @Test
  void filtersByWordsOfAnyColumn() {
    Squad squad = new Squad(12).drives(1, 0, 0, 0.2).drives(12, 0, 0, 0).lose(2);
    assertEquals(List.of("r2"), look(squad).matching("no LINK").stream().map(TeamRow::robot).toList());
    assertEquals(List.of("r2"),
        look(squad).matching(" player refuses ").stream().map(TeamRow::robot).limit(1).toList());
    assertEquals(12, look(squad).matching(" ").size());
  }

  @Test
  void aTeamWithoutRobotsSaysWhatWouldHelp() {
    TeamLook look = look(new Squad(1), "r1");
    assertTrue(look.state().explanation().contains("rfics"));
    assertEquals(Set.of(), look.selected());
  }
}
