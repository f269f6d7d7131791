package org.robotui.entity.robotmodel.internal;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.config.Settings;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.InputState;
import org.robotui.data.Data;
import org.robotui.data.joint.JointState;
import org.robotui.data.joint.RobotDescription;
import org.robotui.data.joint.Trajectory;
import org.robotui.geometry.RigidTransform;
import org.robotui.gl.display.ColorSetting;
import org.robotui.gl.display.Display;
import org.robotui.gl.display.DisplayContext;
import org.robotui.gl.display.DisplayResult;
import org.robotui.gl.display.DisplayStatus;
import org.robotui.gl.display.DisplayTick;
import org.robotui.gl.display.Places;

/**
 * The newest trajectory of a robot. The model is loaded when the first one comes, and shared with other displays of the
 * robot.
 */
final class TrajectoryDisplay implements Display {
  private static final double OLD_SECONDS = 5;
  private static final int MOST_JOINTS = 10_000;

  private final ModelSource source;
  private Optional<Envelope<? extends Data>> newest = Optional.empty();
  private Optional<Shown> shown = Optional.empty();
  private Optional<Long> jointsReceived = Optional.empty();
  private JointState joints = new JointState(List.of());

  TrajectoryDisplay(DisplayContext context, ModelShelf shelf) {
    source = new ModelSource(context, shelf);
  }

  /** What became of the newest trajectory. */
  private sealed interface Shown {
    record Running(ModelSource.Answer answer, Loaded.Model model, Rehearsal rehearsal) implements Shown {}

    record Not(DisplayStatus why) implements Shown {}
  }

  @Override
  public DisplayResult update(DisplayTick tick) {
    if (tick.reset()) {
      newest = Optional.empty();
      shown = Optional.empty();
      joints = new JointState(List.of());
      jointsReceived = Optional.empty();
    }
    boolean moved = take(tick);
    if (newest.isPresent() && source.update(false, tick.settings())) {
      shown = Optional.empty();
    }
    if (shown.isEmpty()) {
      shown = newest.flatMap(envelope -> source.taken().map(answer -> read((Trajectory) envelope.value(), answer)));
    }
    return shown.map(now -> result(now, moved, tick))
        .orElseGet(() -> DisplayResult.nothing(new DisplayStatus.NoData(awaited(tick))));
  }

  /** True where joints came. */
  private boolean take(DisplayTick tick) {
    boolean moved = false;
    for (Envelope<? extends Data> envelope : tick.arrived()) {
      switch (envelope.value()) {
        case RobotDescription told -> source.told(told);
        case JointState state -> {
          joints = state.over(joints).last(MOST_JOINTS);
          jointsReceived = Optional.of(envelope.receivedNanos());
          moved = true;
        }
        case Trajectory trajectory -> {
          newest = Optional.of(envelope);
          shown = Optional.empty();
        }
        default -> {}
      }
    }
    return moved;
  }

  private String awaited(DisplayTick tick) {
    if (newest.isEmpty()) {
      boolean quiet = tick.state() instanceof InputState.Live || tick.state() instanceof InputState.Stale;
      return quiet ? "No trajectory yet: one is shown as soon as a planner or a program sends it."
          : tick.state().explanation();
    }
    return source.described() ? "The model and its meshes are being read."
        : "A trajectory is there, but no description of its robot yet: in ROS it is the parameter robot_description.";
  }

  private Shown read(Trajectory trajectory, ModelSource.Answer answer) {
    return switch (answer.loaded()) {
      case Loaded.Broken broken -> new Shown.Not(new DisplayStatus.Unfit("The model cannot be read: " + broken.why()));
      case Loaded.Model model -> switch (PlanReader.read(trajectory, positions(model), model.model())) {
        case PlanRead.Refused refused -> new Shown.Not(refused.why());
        case PlanRead.Ok ok -> new Shown.Running(answer, model, new Rehearsal(new Course(model, ok.plan())));
      };
    };
  }

  private Map<String, Double> positions(Loaded.Model model) {
    return LinkPoses.newer(Map.of(), joints, model.model());
  }

  private DisplayResult result(Shown now, boolean moved, DisplayTick tick) {
    return switch (now) {
      case Shown.Not not -> DisplayResult.nothing(not.why());
      case Shown.Running running -> result(running, moved, tick);
    };
  }

  private DisplayResult result(Shown.Running running, boolean moved, DisplayTick tick) {
    Settings settings = tick.settings();
    double age = newest.map(envelope -> tick.ageSeconds(envelope.receivedNanos())).orElse(0.0);
    if (settings.number(TrajectoryType.TIMEOUT) > 0 && age > settings.number(TrajectoryType.TIMEOUT)) {
      return DisplayResult
          .nothing(new DisplayStatus.TooOld(String.format(Locale.ROOT, "The newest trajectory came %.0f s ago.", age)));
    }
    Rehearsal rehearsal = running.rehearsal();
    rehearsal.follow(link(running, settings), (float) settings.number(TrajectoryType.WIDTH));
    rehearsal.pass(tick.nowNanos(), settings.number(TrajectoryType.SPEED));
    if (moved) {
      rehearsal.executed(positions(running.model()));
    }
    return switch (LinkPoses.root(running.model().model(), running.answer().robot(),
        settings.text(RobotModelType.TF_PREFIX), tick.places())) {
      case Places.Place.Missing(String reason) -> DisplayResult.nothing(new DisplayStatus.NoFrame(reason));
      case Places.Place.At(RigidTransform root) -> new DisplayResult(rehearsal.parts(root, settings),
          status(running, tick), 0);
    };
  }

  private static String link(Shown.Running running, Settings settings) {
    String wanted = settings.text(TrajectoryType.LINK).strip();
    return running.model().model().link(wanted).isPresent() ? wanted : running.rehearsal().tip();
  }

  private DisplayStatus status(Shown.Running running, DisplayTick tick) {
    Plan plan = running.rehearsal().plan();
    String wanted = tick.settings().text(TrajectoryType.LINK).strip();
    double age = jointsReceived.map(tick::ageSeconds).orElse(0.0);
    if (!plan.remarks().isEmpty()) {
      return new DisplayStatus.Partly("Shown in part: " + String.join("; ", plan.remarks()) + ".");
    }
    if (!wanted.isEmpty() && running.model().model().link(wanted).isEmpty()) {
      return new DisplayStatus.Partly(
          "The model '" + running.model().model().name() + "' has no link '" + wanted + "'.");
    }
    if (age > OLD_SECONDS) {
      return new DisplayStatus.Partly(
          String.format(Locale.ROOT, "The newest joint states are %.0f s old: nothing is compared.", age));
    }
    return ColorSetting.complaint(tick.settings()).<DisplayStatus>map(DisplayStatus.Partly::new)
        .orElseGet(() -> new DisplayStatus.Shown(words(running)));
  }

  private static String words(Shown.Running running) {
    Plan plan = running.rehearsal().plan();
    return String.format(Locale.ROOT, "%d points, %.1f s", plan.points(), plan.duration())
        + running.rehearsal().deviation().farthest()
            .map(away -> "; at most " + away.words() + " off (" + away.joint().name() + ")")
            .orElse("; no joint states to compare with");
  }

  @Override
  public void close() {
    source.close();
    newest = Optional.empty();
    shown = Optional.empty();
  }
}
