package org.robotui.uic.map.internal.view;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.robotui.data.FrameId;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.ui.Face;
import org.robotui.ui.Health;
import org.robotui.ui.Role;
import org.robotui.ui.layer.LayerNote;
import org.robotui.ui.scene.Painter;
import org.robotui.uic.map.internal.model.GoalFailure;
import org.robotui.uic.map.internal.model.MapSnapshot;

/**
 * The goal that was sent last, until the robot is there, the fixed frame is another, or the user is done with it. Why
 * it failed is said beside it, in the words of navigation; where navigation says nothing, but the robot tells what it
 * plans, that there is no path.
 */
final class SentGoal {
  /** After which no path there means that there will be none. */
  static final int PATIENCE_MILLIS = 3000;

  static final String NO_PATH = "no path found";
  static final String GIVEN_UP = "given up";

  /** As far as planners and robots usually may miss a goal. */
  private static final double NEAR = 0.5;
  private static final double RING = 9;
  private static final double LABEL_GAP = 15;
  private static final double ARROW = 30;
  private static final double HEAD = 8;
  private static final double QUIET = 0.7;
  private static final long NANOS = 1_000_000L;

  private record Goal(FrameId frame, RigidTransform pose) {}

  private Optional<Goal> goal = Optional.empty();
  private boolean planned;
  private long since;
  private long sentNanos;

  void at(FrameId frame, RigidTransform pose, long nowNanos) {
    goal = Optional.of(new Goal(frame, pose));
    planned = false;
    since = nowNanos;
    sentNanos = nowNanos;
  }

  void clear() {
    goal = Optional.empty();
  }

  /** Whether there still is one. */
  boolean look(MapSnapshot snapshot, long nowNanos) {
    goal = goal.filter(g -> snapshot.fixed().equals(Optional.of(g.frame())) && !arrived(g, snapshot));
    if (goal.filter(g -> leadsTo(g, snapshot)).isPresent()) {
      planned = true;
      since = nowNanos;
    }
    return goal.isPresent();
  }

  /** What is wrong with it, empty for nothing that is known. */
  String problem(MapSnapshot snapshot, long nowNanos) {
    Optional<GoalFailure> failure = snapshot.failures().stream().filter(f -> f.receivedNanos() - sentNanos >= 0)
        .max(Comparator.comparingLong(f -> f.receivedNanos() - sentNanos));
    if (goal.isPresent() && failure.isPresent()) {
      return failure.get().words();
    }
    boolean late = goal.isPresent() && snapshot.ways().isPresent() && nowNanos - since > PATIENCE_MILLIS * NANOS;
    return !late ? "" : planned ? GIVEN_UP : NO_PATH;
  }

  /** Why it failed, where that is a sentence: it has no room beside the goal. */
  Optional<LayerNote> note(MapSnapshot snapshot, long nowNanos) {
    String problem = problem(snapshot, nowNanos);
    return problem.indexOf(':') < 0 ? Optional.empty() : Optional.of(new LayerNote(Health.WARNING, "goal " + problem));
  }

  void paint(Painter painter, MapSnapshot snapshot, long nowNanos) {
    if (look(snapshot, nowNanos)) {
      String problem = problem(snapshot, nowNanos);
      goal.ifPresent(g -> paint(painter, g.pose(), problem));
    }
  }

  private static void paint(Painter painter, RigidTransform pose, String problem) {
    Vector3 place = pose.translation();
    Role role = problem.isEmpty() ? Role.PLAN : Role.WARNING;
    painter.opacity(problem.isEmpty() ? QUIET : 1).stroke(role).fill(role).width(2);
    painter.circle(place.x(), place.y(), RING);
    Arrow.paint(painter, pose, ARROW, HEAD);
    if (!problem.isEmpty()) {
      painter.label(problem.split(":", 2)[0], place.x(), place.y(), LABEL_GAP, LABEL_GAP, Face.BODY);
    }
  }

  private static boolean leadsTo(Goal goal, MapSnapshot snapshot) {
    return snapshot.ways().orElse(List.of()).stream().anyMatch(end -> near(end, goal));
  }

  private static boolean arrived(Goal goal, MapSnapshot snapshot) {
    return snapshot.robots().stream().anyMatch(r -> near(r.fixedFromBase().translation(), goal));
  }

  private static boolean near(Vector3 place, Goal goal) {
    return place.minus(goal.pose().translation()).norm() < NEAR;
  }
}
