package org.robotui.entity.robotmodel.internal;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.config.Settings;
import org.robotui.api.port.Envelope;
import org.robotui.data.Data;
import org.robotui.data.joint.JointState;
import org.robotui.data.joint.RobotDescription;
import org.robotui.gl.display.Display;
import org.robotui.gl.display.DisplayContext;
import org.robotui.gl.display.DisplayResult;
import org.robotui.gl.display.DisplayStatus;
import org.robotui.gl.display.DisplayTick;
import org.robotui.gl.shape.Part;

/** A robot that moves. Loading is done in the background; until another model is there, the last one is shown. */
final class RobotModelDisplay implements Display {
  private static final double OLD_SECONDS = 5;
  private static final int MOST_JOINTS = 10_000;

  private final ModelSource source;
  private Optional<ModelParts> parts = Optional.empty();
  private Optional<Long> jointsReceived = Optional.empty();
  private JointState joints = new JointState(List.of());
  private volatile Map<String, Double> positions = Map.of();

  RobotModelDisplay(DisplayContext context, ModelShelf shelf) {
    source = new ModelSource(context, shelf);
  }

  @Override
  public DisplayResult update(DisplayTick tick) {
    if (tick.reset()) {
      joints = new JointState(List.of());
      positions = Map.of();
      jointsReceived = Optional.empty();
    }
    tick.arrived().forEach(this::arrived);
    if (source.update(tick.settings().flag(RobotModelType.COLLISION), tick.settings())) {
      source.taken().ifPresent(this::take);
    }
    if (!source.described()) {
      return DisplayResult.nothing(new DisplayStatus.NoData(
          "No description of a robot yet: in ROS it is the parameter robot_description."));
    }
    return source.taken().map(answer -> shown(answer, tick))
        .orElseGet(() -> DisplayResult.nothing(new DisplayStatus.NoData("The model and its meshes are being read.")));
  }

  private void arrived(Envelope<? extends Data> envelope) {
    if (envelope.value() instanceof RobotDescription told) {
      source.told(told);
    }
    if (envelope.value() instanceof JointState state) {
      joints = state.over(joints).last(MOST_JOINTS);
      jointsReceived = Optional.of(envelope.receivedNanos());
      source.taken().ifPresent(this::move);
    }
  }

  private void take(ModelSource.Answer answer) {
    positions = Map.of();
    parts = answer.loaded() instanceof Loaded.Model model ? Optional.of(new ModelParts(model, () -> positions))
        : Optional.empty();
    move(answer);
  }

  private void move(ModelSource.Answer answer) {
    if (answer.loaded() instanceof Loaded.Model model) {
      positions = LinkPoses.newer(positions, joints, model.model());
    }
  }

  private DisplayResult shown(ModelSource.Answer answer, DisplayTick tick) {
    return switch (answer.loaded()) {
      case Loaded.Broken broken -> DisplayResult
          .nothing(new DisplayStatus.Unfit("The model cannot be read: " + broken.why()));
      case Loaded.Model model -> shown(model, answer.robot(), tick);
    };
  }

  private DisplayResult shown(Loaded.Model model, String robot, DisplayTick tick) {
    Settings settings = tick.settings();
    boolean byJoints = byJoints(settings);
    String prefix = settings.text(RobotModelType.TF_PREFIX);
    LinkPoses poses = byJoints
        ? LinkPoses.byJoints(model, robot, prefix, tick.places(), positions)
        : LinkPoses.byTransforms(model.model(), robot, prefix, tick.places());
    List<Part> seen = parts.orElseThrow().parts(poses.fixedFromLinks(), settings, tick.robotColor());
    return new DisplayResult(seen, status(model, poses, byJoints, tick), 0);
  }

  private boolean byJoints(Settings settings) {
    return switch (settings.text(RobotModelType.POSES)) {
      case "tf" -> false;
      case "joints" -> true;
      default -> jointsReceived.isPresent();
    };
  }

  private DisplayStatus status(Loaded.Model model, LinkPoses poses, boolean byJoints, DisplayTick tick) {
    int links = model.model().links().size();
    int placed = poses.fixedFromLinks().size();
    if (placed == 0) {
      return new DisplayStatus.NoFrame(poses.missing());
    }
    if (placed < links) {
      return new DisplayStatus.Partly((links - placed) + " of " + links + " links have no place: " + poses.missing());
    }
    if (!model.problems().isEmpty()) {
      int more = model.problems().size() - 1;
      return new DisplayStatus.Partly(model.problems().getFirst() + (more > 0 ? " (and " + more + " more)" : ""));
    }
    String group = tick.settings().text(RobotModelType.GROUP);
    List<String> groups = parts.map(ModelParts::groups).orElse(List.of());
    if (!group.isEmpty() && !groups.contains(group)) {
      return new DisplayStatus.Partly("There is no group '" + group + "': "
          + (groups.isEmpty() ? "the robot tells no SRDF" : "there are " + groups));
    }
    return byJoints ? jointStatus(model, tick) : words(model);
  }

  private DisplayStatus jointStatus(Loaded.Model model, DisplayTick tick) {
    if (jointsReceived.isEmpty()) {
      return new DisplayStatus.Partly(
          "No joint states yet: all joints are shown at 0. Choose a source of joint states, or poses: tf.");
    }
    double age = tick.ageSeconds(jointsReceived.get());
    return age > OLD_SECONDS
        ? new DisplayStatus.Partly(
            String.format(Locale.ROOT, "The newest joint states are %.0f s old: shown as last known.", age))
        : words(model);
  }

  private static DisplayStatus words(Loaded.Model model) {
    return new DisplayStatus.Shown(model.model().links().size() + " links");
  }

  @Override
  public void close() {
    source.close();
    parts = Optional.empty();
  }
}
