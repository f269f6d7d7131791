package org.robotui.uic.map.internal.view;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.robotui.data.FrameId;
import org.robotui.geometry.RigidTransform;
import org.robotui.ui.Health;
import org.robotui.ui.control.PopupMenu;
import org.robotui.ui.layer.SeenRobot;
import org.robotui.ui.scene.CommandNotice;
import org.robotui.uic.map.internal.model.Team;

/** Selects robots of a team and sends those that are selected somewhere. Display thread. */
final class TeamHands {
  private static final double GAP_PER_RADIUS = 4;
  private static final double LEAST_GAP = 0.8;

  private final MapCanvas map;
  private final Team team;
  private final TeamGoals goals;

  TeamHands(MapCanvas map, Team team, TeamGoals goals) {
    this.map = map;
    this.team = team;
    this.goals = goals;
  }

  /** Whether goals go to selected robots. */
  boolean isTeam() {
    return team.isSeveral();
  }

  /** A click on a robot selects it, with Ctrl or Shift beside others; a click on the floor none. */
  void click(Optional<SeenRobot> robot, boolean beside) {
    Set<String> next = new LinkedHashSet<>(beside ? team.selected() : Set.of());
    robot.map(SeenRobot::name).filter(name -> !beside || !next.remove(name)).ifPresent(next::add);
    if (robot.isPresent() || !beside) {
      team.select(next);
    }
  }

  /** Who a goal goes to now. */
  private List<String> meant() {
    Set<String> able = goals.robots();
    return team.selected().stream().filter(able::contains).toList();
  }

  /** Sends who is selected; all only after a question. */
  void send(FrameId fixed, RigidTransform pose, Runnable question) {
    List<String> meant = meant();
    if (meant.isEmpty()) {
      map.say(new CommandNotice(Health.WARNING, "Not sent: select robots first, here or in the team's table"));
    } else if (meant.size() == goals.robots().size() && meant.size() > 1) {
      question.run();
    } else {
      send(meant, fixed, pose);
    }
  }

  /** Tells the one that is selected where it is. */
  CommandNotice place(FrameId fixed, RigidTransform pose) {
    Set<String> selected = team.selected();
    return selected.size() == 1 ? goals.place(selected.iterator().next(), fixed, pose)
        : new CommandNotice(Health.WARNING,
            "Not sent: select the one robot that is there, here or in the team's table");
  }

  /** Where the one that is selected looks. */
  Optional<SeenRobot> meantPlace(List<SeenRobot> robots) {
    return robots.stream().filter(robot -> team.selected().size() == 1 && team.selected().contains(robot.name()))
        .findFirst();
  }

  /** Sends all who are selected, without a question. */
  void sendMeant(FrameId fixed, RigidTransform pose) {
    send(meant(), fixed, pose);
  }

  private void send(List<String> robots, FrameId fixed, RigidTransform pose) {
    TeamGoals.Sent sent = goals.send(robots, fixed, pose, Math.max(LEAST_GAP, GAP_PER_RADIUS * map.robotRadius()));
    map.mark(fixed, sent.spots());
    map.say(sent.told());
  }

  /** What a menu offers at a place. */
  void menu(PopupMenu menu, FrameId fixed, RigidTransform pose) {
    List<String> meant = meant();
    boolean all = meant.size() > 1 && meant.size() == goals.robots().size();
    if (meant.isEmpty()) {
      menu.push("Send a goal here (select robots first)", false, () -> {});
    } else if (all) {
      menu.under("Send all " + meant.size() + " robots here").push("Yes, all " + meant.size(),
          () -> send(meant, fixed, pose));
    } else {
      menu.push("Send " + (meant.size() == 1 ? meant.getFirst() : meant.size() + " robots") + " here",
          () -> send(meant, fixed, pose));
    }
    menu.push("Select all robots", () -> team.select(goals.robots()));
  }
}
