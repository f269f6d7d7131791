package org.robotui.rfic.xbot.internal;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.robotui.api.RficContext;
import org.robotui.api.port.Publication;
import org.robotui.api.port.StreamPort;
import org.robotui.data.ClockKind;
import org.robotui.data.Data;
import org.robotui.data.Stamp;
import org.robotui.data.control.ControlPlugins;
import org.robotui.data.control.Drives;
import org.robotui.data.control.LoopTiming;
import org.robotui.data.geometry.Wrench;
import org.robotui.data.joint.JointControl;
import org.robotui.data.joint.JointModel;
import org.robotui.data.joint.JointState;
import org.robotui.data.joint.RobotDescription;
import org.robotui.data.joint.Trajectory;
import org.robotui.data.marker.InteractiveMarkerSet;
import org.robotui.data.sensor.Imu;
import org.robotui.data.status.Diagnostics;
import org.robotui.rfic.xbot.internal.task.HandleSite;
import org.robotui.xbot.Board;
import org.robotui.xbot.HostReading;
import org.robotui.xbot.StateFrame;
import org.robotui.xbot.Timing;

/** Publishes what a control says, and converts only what somebody wants. One thread publishes. */
final class Streams implements AutoCloseable {
  private static final long MILLI = 1_000_000L;

  private final RficContext context;
  private final Stream<JointState> joints;
  private final Stream<JointControl> control;
  private final Stream<JointModel> model;
  private final Stream<ControlPlugins> plugins;
  private final Stream<LoopTiming> timing;
  private final Stream<Drives> drives;
  private final Stream<Diagnostics> diagnostics;
  private final List<Stream<Imu>> imus;
  private final List<Stream<Wrench>> forceTorques;
  private final List<Publication<?>> all = new ArrayList<>();
  private final ModelFrames frames;
  private Optional<JointModel> modelTold = Optional.empty();

  /** A publication, and whether anybody wants it. */
  private final class Stream<T extends Data> {
    private volatile boolean wanted;
    private final Publication<T> publication;

    Stream(StreamPort<T> port) {
      this.publication = context.offers().stream(port, now -> this.wanted = now);
      all.add(publication);
    }
  }

  Streams(RficContext context, Board board, ModelFrames frames) {
    this.context = context;
    this.frames = frames;
    this.joints = new Stream<>(XbotPorts.JOINTS);
    this.control = new Stream<>(XbotPorts.CONTROL);
    this.model = new Stream<>(XbotPorts.MODEL);
    this.plugins = new Stream<>(XbotPorts.PLUGINS);
    this.timing = new Stream<>(XbotPorts.TIMING);
    this.drives = new Stream<>(XbotPorts.DRIVES);
    this.diagnostics = new Stream<>(XbotPorts.DIAGNOSTICS);
    this.imus = board.imus().stream().map(name -> new Stream<>(XbotPorts.imu(name))).toList();
    this.forceTorques = board.forceTorques().stream().map(name -> new Stream<>(XbotPorts.forceTorque(name))).toList();
  }

  /** What the robot is made of, offered from now on. */
  void describe(RobotDescription description) {
    new Stream<>(XbotPorts.DESCRIPTION).publication.publish(description, Optional.empty());
    context.frames().add(frames.fixed(stamp(System.nanoTime())), ModelFrames.AUTHORITY);
  }

  /** Where handles of tasks are shown, offered from now on. */
  HandleSite handleSite() {
    Stream<InteractiveMarkerSet> handles = new Stream<>(XbotPorts.HANDLES);
    Stream<Trajectory> plan = new Stream<>(XbotPorts.PLAN);
    return new HandleSite() {
      @Override
      public boolean wanted() {
        return handles.wanted;
      }

      @Override
      public void handles(InteractiveMarkerSet now) {
        handles.publication.publish(now, Optional.of(stamp(System.nanoTime())));
      }

      @Override
      public void plan(Trajectory newest) {
        plan.publication.publish(newest, Optional.of(stamp(System.nanoTime())));
      }
    };
  }

  /** What changes in every cycle. */
  void publish(Board board, StateFrame state) {
    long measured = state.sensedNanos();
    Optional<Stamp> stamp = Optional.of(stamp(measured));
    JointState positions = Convert.joints(board, state);
    context.frames().add(frames.moving(positions, stamp(measured)), ModelFrames.AUTHORITY);
    if (joints.wanted) {
      joints.publication.publish(positions, stamp, measured, Optional.empty());
    }
    if (control.wanted) {
      control.publication.publish(Convert.control(board, state), stamp, measured, Optional.empty());
    }
    IntStream.range(0, Math.min(imus.size(), state.imus().size())).filter(i -> imus.get(i).wanted)
        .forEach(i -> imus.get(i).publication.publish(
            Convert.imu(frames.sensor(board.imus().get(i)), state.imus().get(i)), stamp, measured,
            Optional.empty()));
    IntStream.range(0, Math.min(forceTorques.size(), state.forceTorques().size()))
        .filter(i -> forceTorques.get(i).wanted).forEach(i -> forceTorques.get(i).publication.publish(
            Convert.wrench(frames.sensor(board.forceTorques().get(i)), state.forceTorques().get(i)), stamp, measured,
            Optional.empty()));
  }

  /** Whether somebody looks at the drives. */
  boolean wantsDrives() {
    return drives.wanted;
  }

  /** Where the drives stand, a few times a second. */
  void publish(Drives now) {
    drives.publication.publish(now, Optional.of(stamp(System.nanoTime())));
  }

  /** Whether somebody looks at the emergency stops. */
  boolean wantsStops() {
    return diagnostics.wanted;
  }

  /** How the emergency stops stand, a few times a second. */
  void publish(Diagnostics now) {
    diagnostics.publication.publish(now, Optional.of(stamp(System.nanoTime())));
  }

  /** What users look at a few times a second. */
  void publishSlow(Board board, Timing loop, List<HostReading> hosts) {
    Optional<Stamp> now = Optional.of(stamp(System.nanoTime()));
    JointModel described = Convert.model(board);
    if (!modelTold.equals(Optional.of(described))) {
      modelTold = Optional.of(described);
      model.publication.publish(described, now);
    }
    if (plugins.wanted) {
      plugins.publication.publish(Convert.plugins(board, hosts), now);
    }
    if (timing.wanted) {
      timing.publication.publish(Convert.timing(board, loop, hosts), now);
    }
  }

  /** The control is of this machine: its monotonic clock is ours. */
  private static Stamp stamp(long monotonic) {
    return new Stamp(System.currentTimeMillis() * MILLI - (System.nanoTime() - monotonic), ClockKind.WALL);
  }

  @Override
  public void close() {
    all.forEach(Publication::close);
  }
}
