package org.robotui.rfic.player.internal.device;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.robotui.data.joint.JointCommand;
import org.robotui.data.joint.JointControl;
import org.robotui.data.joint.JointMode;
import org.robotui.data.joint.JointModel;
import org.robotui.data.joint.JointState;
import org.robotui.player.interfaces.Actarray;
import org.robotui.rfic.player.internal.convert.Joints;

/** A row of actuators: its joints, their bounds, and driving them by positions or by velocities. */
final class Arm {
  private static final Set<JointMode> POSITION = Set.of(JointMode.POSITION);
  private static final Set<JointMode> VELOCITY = Set.of(JointMode.VELOCITY);

  private final DeviceFeed feed;
  private final Outlet<JointState> states;
  private final Outlet<JointControl> controls;
  private final Outlet<JointModel> models;
  private final Map<Integer, Double> targets = new ConcurrentHashMap<>();
  private volatile Optional<Actarray.State> state = Optional.empty();
  private volatile boolean speeding;

  Arm(DeviceFeed feed) {
    this.feed = feed;
    this.states = feed.outlet("", JointState.class, "its joints");
    this.controls = feed.outlet("/control", JointControl.class, "where its joints were sent from here");
    this.models = feed.outlet("/model", JointModel.class, "the bounds of its joints");
    feed.onOpen(() -> feed.ask(Actarray.GET_GEOMETRY,
        g -> models.publish(Joints.model(g, feed.name()), Reception.now()), models::failed));
    feed.on(Actarray.STATE, states, this::told);
    feed.command("/joints", JointCommand.class, "positions or velocities of its joints",
        new Driving<>(feed, this::out, this::out, JointCommand.ZERO, this::refusal));
  }

  private void told(Actarray.State m, Reception reception) {
    state = Optional.of(m);
    states.publish(Joints.state(m, feed.name()), reception);
    controls.publish(Joints.control(m, feed.name(), targets), reception);
  }

  private Optional<String> refusal(JointCommand command) {
    try {
      command.joints().forEach(j -> state.ifPresent(s -> Joints.index(j, feed.name(), s.actuators().size())));
    } catch (IllegalArgumentException e) {
      return Optional.of(e.getMessage());
    }
    List<Set<JointMode>> modes = command.joints().stream().map(JointCommand.Joint::modes).distinct().toList();
    return modes.isEmpty() || modes.equals(List.of(POSITION)) || modes.equals(List.of(VELOCITY)) ? Optional.empty()
        : Optional
            .of(feed.name() + " is driven by positions or by velocities, all joints by the same; not by " + modes);
  }

  /** Before the first state nothing is sent: the other joints would be told to go to 0. */
  private boolean out(JointCommand command) {
    Optional<Actarray.State> now = state.filter(s -> feed.open());
    return now.isPresent() && (command.joints().isEmpty() ? halt(now.get()) : move(command, now.get()));
  }

  private boolean move(JointCommand command, Actarray.State now) {
    int joints = now.actuators().size();
    speeding = command.joints().getFirst().modes().equals(VELOCITY);
    if (speeding) {
      float[] speeds = new float[joints];
      command.joints().forEach(j -> speeds[Joints.index(j, feed.name(), joints)] = (float) j.reference().velocity());
      return feed.device().command(Actarray.SPEEDS, new Actarray.Speeds(speeds));
    }
    command.joints().forEach(j -> targets.put(Joints.index(j, feed.name(), joints), j.reference().position()));
    return feed.device().command(Actarray.POSITIONS, new Actarray.Positions(positions(now)));
  }

  /** Joints that were never sent anywhere stay where they are. */
  private float[] positions(Actarray.State now) {
    float[] positions = new float[now.actuators().size()];
    for (int i = 0; i < positions.length; i++) {
      positions[i] = targets.getOrDefault(i, (double) now.actuators().get(i).position()).floatValue();
    }
    return positions;
  }

  /** What we sent on its way stays where it is; an arm that we did not move is left alone. */
  private boolean halt(Actarray.State now) {
    boolean ours = speeding || !targets.isEmpty();
    targets.clear();
    if (speeding) {
      speeding = false;
      return feed.device().command(Actarray.SPEEDS, new Actarray.Speeds(new float[now.actuators().size()]));
    }
    return !ours || feed.device().command(Actarray.POSITIONS, new Actarray.Positions(positions(now)));
  }
}
