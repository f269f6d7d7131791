package org.robotui.entity.robotmodel.internal;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.robotui.data.array.Doubles;
import org.robotui.data.joint.DisplayedTrajectory;
import org.robotui.data.joint.JointState;
import org.robotui.data.joint.JointTrajectory;
import org.robotui.data.joint.Trajectory;
import org.robotui.gl.display.DisplayStatus;
import org.robotui.urdf.Joint;
import org.robotui.urdf.RobotModel;

/**
 * Checks a trajectory against a model. Of one with more points than are kept, every n-th and the last stay. One
 * trajectory each.
 */
final class PlanReader {
  /** The most points that are kept. */
  static final int MOST_POINTS = 10_000;
  private static final int MOST_NUMBERS = 1_000_000;
  private static final double STEP_SECONDS = 0.1;

  private final RobotModel model;
  private final List<JointTrajectory> parts;
  private final Map<String, Double> start;
  private final List<Joint> joints = new ArrayList<>();
  private final List<String> remarks = new ArrayList<>();

  private PlanReader(Trajectory trajectory, Map<String, Double> now, RobotModel model) {
    this.model = model;
    start = new HashMap<>(now);
    parts = switch (trajectory) {
      case JointTrajectory one -> List.of(one);
      case DisplayedTrajectory displayed -> {
        displayed.start().forEach(this::starts);
        yield displayed.parts().stream().filter(part -> !part.points().isEmpty()).toList();
      }
    };
  }

  /**
   * Reads one.
   *
   * @param trajectory of any source, nothing of it is trusted
   * @param now where the joints of the model are, as far as known
   * @param model the robot
   */
  static PlanRead read(Trajectory trajectory, Map<String, Double> now, RobotModel model) {
    if (trajectory instanceof DisplayedTrajectory displayed && displayed.parts().isEmpty()) {
      return new PlanRead.Refused(new DisplayStatus.Shown("nothing is planned"));
    }
    PlanReader reader = new PlanReader(trajectory, now, model);
    if (reader.points() == 0) {
      return new PlanRead.Refused(new DisplayStatus.NoData("The newest trajectory has no points: nothing is planned."));
    }
    try {
      return new PlanRead.Ok(reader.plan());
    } catch (Unfit unfit) {
      return new PlanRead.Refused(new DisplayStatus.Unfit(unfit.getMessage()));
    }
  }

  /** Ends the reading. */
  private static final class Unfit extends Exception {
    private static final long serialVersionUID = 1;

    Unfit(String why) {
      super(why);
    }
  }

  private void starts(JointState.Joint joint) {
    if (Double.isFinite(joint.position()) && model.joint(joint.name()).isPresent()) {
      start.put(joint.name(), joint.position());
    }
  }

  private long points() {
    return parts.stream().mapToLong(part -> part.points().size()).sum();
  }

  private Plan plan() throws Unfit {
    long points = points();
    findJoints();
    boolean timed = parts.stream().flatMap(part -> part.points().stream()).anyMatch(point -> point.seconds() != 0);
    if (!timed && points > 1) {
      remarks.add("its points tell no times: shown with " + STEP_SECONDS + " s between them");
    }
    long most = Math.max(2, Math.min(MOST_POINTS, MOST_NUMBERS / joints.size()));
    long every = (points + most - 1) / most;
    if (every > 1) {
      remarks.add("of " + points + " points every " + every + "th is shown");
    }
    return kept(timed, every, points);
  }

  private void findJoints() throws Unfit {
    Set<String> named = new LinkedHashSet<>();
    parts.forEach(part -> named.addAll(part.joints()));
    if (named.isEmpty()) {
      throw new Unfit("The trajectory names no joints.");
    }
    named.stream().flatMap(name -> model.joint(name).stream()).filter(joint -> joint.type().single())
        .forEach(joints::add);
    Optional<String> missing =
        named.stream().filter(name -> model.joint(name).filter(joint -> joint.type().single()).isEmpty()).findFirst();
    int lacking = named.size() - joints.size();
    String words = missing.map(name -> "the model '" + model.name() + "' has no movable joint '" + name + "'"
        + (lacking > 1 ? " (and " + (lacking - 1) + " more of the trajectory)" : "")).orElse("");
    if (joints.isEmpty()) {
      throw new Unfit("Nothing of the trajectory can be shown: " + words + ".");
    }
    missing.ifPresent(name -> remarks.add(words));
  }

  private Plan kept(boolean timed, long every, long points) throws Unfit {
    Points kept = new Points(joints, start);
    double offset = 0;
    long number = 0;
    for (JointTrajectory part : parts) {
      Map<String, Integer> columns = columns(part);
      double last = 0;
      for (int i = 0; i < part.points().size(); i++) {
        JointTrajectory.Point point = part.points().get(i);
        double time = timed ? point.seconds() : i * STEP_SECONDS;
        check(point, time, i == 0 ? -1 : last, number);
        kept.move(columns, point.positions());
        if (number == 0 && time > 0) {
          kept.start();
        }
        if (number % every == 0 || number == points - 1) {
          kept.add(offset + time);
        }
        number++;
        last = time;
      }
      offset += timed ? last : last + STEP_SECONDS;
    }
    return kept.plan(remarks);
  }

  private static Map<String, Integer> columns(JointTrajectory part) {
    Map<String, Integer> columns = new LinkedHashMap<>();
    for (int i = 0; i < part.joints().size(); i++) {
      columns.putIfAbsent(part.joints().get(i), i);
    }
    return columns;
  }

  private static void check(JointTrajectory.Point point, double time, double before, long number) throws Unfit {
    if (point.positions().size() == 0) {
      throw new Unfit("Point " + number + " of the trajectory has no positions.");
    }
    if (!(time > before) || !(time >= 0) || !Double.isFinite(time)) {
      throw new Unfit(
          "The times of the trajectory do not increase: point " + number + " is at " + time + " s, the one before at "
              + Math.max(0, before) + " s.");
    }
    Doubles positions = point.positions();
    for (int i = 0; i < positions.size(); i++) {
      if (!Double.isFinite(positions.get(i))) {
        throw new Unfit("Point " + number + " of the trajectory has a position that is no finite number.");
      }
    }
  }
}
