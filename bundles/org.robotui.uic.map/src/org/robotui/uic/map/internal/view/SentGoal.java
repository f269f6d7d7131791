package org.robotui.uic.map.internal.view;

import java.util.Optional;
import org.robotui.data.FrameId;
import org.robotui.geometry.RigidTransform;
import org.robotui.ui.Role;
import org.robotui.ui.scene.Painter;
import org.robotui.uic.map.internal.model.MapSnapshot;

/** The goal that was sent last, until the robot is there, the fixed frame is another, or the user is done with it. */
final class SentGoal {
  private static final double ARRIVED = 0.3;
  private static final double RING = 9;
  private static final double ARROW = 30;
  private static final double HEAD = 8;
  private static final double QUIET = 0.7;

  private record Goal(FrameId frame, RigidTransform pose) {}

  private Optional<Goal> goal = Optional.empty();

  void at(FrameId frame, RigidTransform pose) {
    goal = Optional.of(new Goal(frame, pose));
  }

  void clear() {
    goal = Optional.empty();
  }

  void paint(Painter painter, MapSnapshot snapshot) {
    goal = goal.filter(g -> snapshot.fixed().equals(Optional.of(g.frame())) && !arrived(g, snapshot));
    goal.ifPresent(g -> {
      painter.opacity(QUIET).stroke(Role.PLAN).fill(Role.PLAN).width(2);
      painter.circle(g.pose().translation().x(), g.pose().translation().y(), RING);
      Arrow.paint(painter, g.pose(), ARROW, HEAD);
    });
  }

  private static boolean arrived(Goal goal, MapSnapshot snapshot) {
    return snapshot.robots().stream()
        .anyMatch(r -> r.fixedFromBase().translation().minus(goal.pose().translation()).norm() < ARRIVED);
  }
}
