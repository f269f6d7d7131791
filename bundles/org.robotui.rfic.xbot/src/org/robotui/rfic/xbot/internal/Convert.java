package org.robotui.rfic.xbot.internal;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.robotui.data.FrameId;
import org.robotui.data.control.ControlPlugins;
import org.robotui.data.control.Histogram;
import org.robotui.data.control.LoopTiming;
import org.robotui.data.geometry.Wrench;
import org.robotui.data.joint.JointControl;
import org.robotui.data.joint.JointMode;
import org.robotui.data.joint.JointModel;
import org.robotui.data.joint.JointState;
import org.robotui.data.sensor.Imu;
import org.robotui.xbot.Board;
import org.robotui.xbot.HostReading;
import org.robotui.xbot.StateFrame;
import org.robotui.xbot.Timing;

/**
 * What a control says, as data types. Indices of a board that was replaced meanwhile may lead nowhere: then the part is
 * left out.
 */
final class Convert {
  private Convert() {}

  static JointState joints(Board board, StateFrame state) {
    return new JointState(IntStream.range(0, count(board, state)).mapToObj(i -> {
      StateFrame.Joint joint = state.joints().get(i);
      return new JointState.Joint(board.joints().get(i).name(), joint.linkPosition(), joint.linkVelocity(),
          joint.effort());
    }).toList());
  }

  private static int count(Board board, StateFrame state) {
    return Math.min(board.joints().size(), state.joints().size());
  }

  static JointControl control(Board board, StateFrame state) {
    return new JointControl(IntStream.range(0, count(board, state))
        .mapToObj(i -> joint(board, board.joints().get(i).name(), state.joints().get(i))).toList());
  }

  private static JointControl.Joint joint(Board board, String name, StateFrame.Joint joint) {
    StateFrame.Reference reference = joint.reference();
    return new JointControl.Joint(name,
        new JointControl.Measured(joint.linkPosition(), joint.motorPosition(), joint.linkVelocity(),
            joint.motorVelocity(),
            joint.effort(), joint.motorTemperature(), joint.driverTemperature()),
        new JointControl.Reference(reference.position(), reference.velocity(), reference.effort(),
            reference.stiffness(),
            reference.damping()),
        JointMode.ofBits(joint.mode()),
        source(joint.control()),
        CycleMessages.owner(board, joint),
        joint.faults(), joint.clamped(), joint.rejected());
  }

  private static JointControl.Source source(StateFrame.Control control) {
    return switch (control) {
      case FREE -> JointControl.Source.FREE;
      case COMMANDED -> JointControl.Source.COMMANDED;
      case HOLDING -> JointControl.Source.HOLDING;
      case SAFE -> JointControl.Source.SAFE;
    };
  }

  static JointModel model(Board board) {
    List<String> names = board.joints().stream().map(Board.Joint::name).toList();
    return new JointModel(
        board.joints().stream().map(j -> new JointModel.Joint(j.name(), j.id(),
            j.prismatic() ? JointModel.Type.PRISMATIC : JointModel.Type.REVOLUTE, j.lower(), j.upper(), j.velocity(),
            j.effort()))
            .toList(),
        board.chains().stream().map(c -> new JointModel.Chain(c.name(),
            c.joints().stream().filter(i -> i < names.size()).map(names::get).toList())).toList());
  }

  static Imu imu(FrameId frame, StateFrame.Imu imu) {
    return new Imu(frame, Optional.of(imu.orientation()), Optional.of(imu.angularVelocity()),
        Optional.of(imu.linearAcceleration()));
  }

  static Wrench wrench(FrameId frame, StateFrame.ForceTorque measured) {
    return new Wrench(frame, measured.force(), measured.torque());
  }

  static LoopTiming timing(Board board, Timing hal, List<HostReading> hosts) {
    List<LoopTiming.Loop> loops = new ArrayList<>(List.of(loop(hal, "HAL")));
    for (int host = 0; host < Math.min(hosts.size(), board.hosts().size()); host++) {
      String process = board.hosts().get(host).name();
      hosts.get(host).threads().forEach(thread -> loops.add(loop(thread, process)));
    }
    return new LoopTiming(board.realTime(), loops);
  }

  private static LoopTiming.Loop loop(Timing timing, String process) {
    return new LoopTiming.Loop(timing.name(), process,
        new LoopTiming.Schedule(timing.period(), timing.priority(), timing.core()),
        new LoopTiming.Counts(timing.cycles(), timing.overruns(), timing.missed(), timing.allocations(),
            timing.pageFaults()),
        histogram(timing.wakeUp()), histogram(timing.busy()));
  }

  static Histogram histogram(Timing.Buckets buckets) {
    return new Histogram(buckets.counts(),
        IntStream.range(0, buckets.counts().size()).mapToObj(i -> i == 0 ? 0L : Timing.Buckets.lower(i)).toList(),
        buckets.max());
  }

  /**
   * Which hosts have memory that a plugin has overwritten, so that their figures are left out; empty where none has.
   */
  static String damage(Board board, List<HostReading> hosts) {
    return IntStream.range(0, Math.min(hosts.size(), board.hosts().size()))
        .filter(i -> !hosts.get(i).damage().isEmpty())
        .mapToObj(i -> "the memory of the host " + board.hosts().get(i).name() + " is damaged ("
            + hosts.get(i).damage() + "): its figures are left out")
        .collect(Collectors.joining("; "));
  }

  static ControlPlugins plugins(Board board, List<HostReading> hosts) {
    return new ControlPlugins(IntStream.range(0, board.plugins().size())
        .mapToObj(i -> plugin(board, i, board.plugins().get(i), hosts)).toList());
  }

  private static ControlPlugins.Plugin plugin(Board board, int index, Board.Plugin plugin, List<HostReading> hosts) {
    Optional<HostReading> host = at(hosts, plugin.host());
    Optional<Timing> thread = host.flatMap(h -> at(h.threads(), plugin.thread()));
    Optional<HostReading.Plugin> reading = host.map(h -> h.plugins().get(index));
    return new ControlPlugins.Plugin(plugin.name(), plugin.type(),
        at(board.hosts(), plugin.host()).map(Board.Host::name).orElse(""), thread.map(Timing::name).orElse(""),
        ControlPlugins.State.valueOf(plugin.state().name()), plugin.status(), plugin.error(), plugin.respawns(),
        thread.map(Timing::period).orElse(0L), reading.map(HostReading.Plugin::cycles).orElse(0L),
        histogram(reading.map(HostReading.Plugin::busy).orElse(new Timing.Buckets(List.of(), 0))));
  }

  private static <T> Optional<T> at(List<T> list, int index) {
    return index >= 0 && index < list.size() ? Optional.of(list.get(index)) : Optional.empty();
  }
}
