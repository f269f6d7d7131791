package org.robotui.uic.team.internal.model;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.UicContext;
import org.robotui.api.command.Authority;
import org.robotui.api.host.ComponentStatus;
import org.robotui.api.host.PortStatus;
import org.robotui.api.host.RuicSnapshot;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.Input;
import org.robotui.api.port.InputState;
import org.robotui.api.port.PortKind;
import org.robotui.data.Data;
import org.robotui.data.FrameId;
import org.robotui.data.navigation.NavigationGoal;
import org.robotui.data.navigation.Odometry;
import org.robotui.data.sensor.Battery;
import org.robotui.geometry.Vector3;
import org.robotui.ui.Figures;
import org.robotui.ui.Health;
import org.robotui.ui.LinkLook;
import org.robotui.ui.scene.FixedFrame;
import org.robotui.ui.scene.Placer;
import org.robotui.uic.team.internal.TeamPorts;
import org.robotui.uic.team.internal.model.Tasks.Task;

/** Puts together how every robot is doing. Worker thread. */
public final class TeamModel {
  /** How often components are asked for: that costs for each port of each robot. */
  private static final long LOOK_NANOS = 1_000_000_000L;
  private static final double MOVING = 0.02;
  private static final double TURNING = 0.05;

  private final UicContext context;
  private final List<String> leftOut;
  private final Input<Odometry> odometry;
  private final Input<Battery> batteries;
  private final Tasks tasks;
  private List<Member> members = List.of();
  private Map<String, PortStatus> goals = Map.of();
  private long lookedAt;
  private boolean looked;

  /**
   * A team.
   *
   * @param context of the view
   * @param leftOut robots that are none
   * @param task how the names of streams end that tell what robots do
   */
  public TeamModel(UicContext context, List<String> leftOut, String task) {
    this.context = context;
    this.leftOut = List.copyOf(leftOut);
    this.odometry = context.input(TeamPorts.ODOM);
    this.batteries = context.input(TeamPorts.BATTERY);
    this.tasks = new Tasks(context.input(TeamPorts.TASK), task);
  }

  /** How they are doing now. */
  public TeamLook tick(long nowNanos) {
    if (!looked || nowNanos - lookedAt >= LOOK_NANOS) {
      look();
      lookedAt = nowNanos;
      looked = true;
    }
    tasks.choose();
    Optional<Placer> placer =
        FixedFrame.choose(Optional.empty(), context.frames(), List.of()).map(f -> new Placer(context.frames(), f));
    List<TeamRow> rows = members.stream().map(m -> row(m, placer, nowNanos)).toList();
    return new TeamLook(rows, context.ruic().selection().robots(), state());
  }

  private InputState state() {
    return members.isEmpty()
        ? new InputState.Unconnected(
            "This view lists robots, and there are none. Write them under 'rfics', each with a name: robot.")
        : new InputState.Live(0, 0);
  }

  private void look() {
    RuicSnapshot snapshot = context.ruic().snapshot();
    Map<String, List<ComponentStatus>> byRobot = new LinkedHashMap<>();
    for (ComponentStatus c : snapshot.components()) {
      if (c.kind() == ComponentStatus.Kind.RFIC) {
        context.ruic().authority(c.id()).map(Authority::robot)
            .ifPresent(robot -> byRobot.computeIfAbsent(robot, r -> new ArrayList<>()).add(c));
      }
    }
    List<Member> next = new ArrayList<>();
    List<String> order = context.ruic().authorities().stream().map(Authority::robot).toList();
    for (int i = 0; i < order.size(); i++) {
      List<ComponentStatus> interfaces = byRobot.getOrDefault(order.get(i), List.of());
      if (!leftOut.contains(order.get(i)) && !interfaces.isEmpty()) {
        next.add(new Member(order.get(i), i, List.copyOf(interfaces)));
      }
    }
    members = List.copyOf(next);
    goals = sentGoals(snapshot);
  }

  private static Map<String, PortStatus> sentGoals(RuicSnapshot snapshot) {
    Map<String, PortStatus> sent = new LinkedHashMap<>();
    String goal = NavigationGoal.class.getSimpleName();
    snapshot.ports().stream()
        .filter(p -> p.kind() == PortKind.COMMAND && p.typeName().equals(goal) && !Double.isNaN(p.ageSeconds()))
        .forEach(p -> sent.merge(p.port().component(), p, (a, b) -> a.ageSeconds() < b.ageSeconds() ? a : b));
    return sent;
  }

  private TeamRow row(Member member, Optional<Placer> placer, long nowNanos) {
    Optional<Envelope<Odometry>> at = newest(odometry, member);
    Optional<Battery> battery = newest(batteries, member).map(Envelope::value);
    Condition condition =
        Condition.of(member, odometry, at.map(Envelope::value).map(TeamModel::isMoving), stopper(member));
    ComponentStatus worst = member.worst();
    Task task = task(member);
    double charge = battery.map(Battery::charge).orElse(Double.NaN);
    Optional<Vector3> joined = at.flatMap(e -> placer.flatMap(p -> place(p, e)));
    Optional<Vector3> place = joined.or(() -> at.map(e -> e.value().pose().translation()));
    String frame = joined.flatMap(j -> placer.map(p -> p.fixed().toString()))
        .or(() -> at.map(e -> e.value().frame().toString())).orElse("");
    return new TeamRow(member.robot(), member.number(), member.framework(), member.linkWord(), LinkLook.health(worst),
        LinkLook.text(worst), condition.doing(), words(condition, at), condition.why(), charge, charge(battery),
        task.words(), task.health(), place, frame, at.map(e -> Math.max(0, e.ageSeconds(nowNanos))).orElse(Double.NaN));
  }

  private Optional<String> stopper(Member member) {
    return context.ruic().authority(member.interfaces().getFirst().id()).flatMap(Authority::stoppedBy)
        .map(by -> by.label());
  }

  private static String words(Condition condition, Optional<Envelope<Odometry>> at) {
    return condition.doing() != Activity.DRIVING ? condition.words()
        : at.map(e -> e.value())
            .map(o -> condition.words() + "  " + Figures.of(Math.hypot(o.linear().x(), o.linear().y()), 2, "m/s"))
            .orElse(condition.words());
  }

  private Task task(Member member) {
    return tasks.of(member).filter(t -> !t.words().isEmpty()).orElseGet(() -> member.interfaces().stream()
        .flatMap(c -> Optional.ofNullable(goals.get(c.id())).stream()).findFirst()
        .map(p -> new Task("goal sent " + Figures.age(p.ageSeconds()) + " ago", Health.NONE)).orElse(Task.NONE));
  }

  private static String charge(Optional<Battery> battery) {
    return battery.map(b -> Double.isNaN(b.charge())
        ? Double.isNaN(b.voltage()) ? "" : Figures.of(b.voltage(), 1, "V")
        : Figures.of(100 * b.charge(), 0, "%")).orElse("");
  }

  private static Optional<Vector3> place(Placer placer, Envelope<Odometry> e) {
    FrameId base = e.value().childFrame();
    return (base.name().isEmpty() ? Optional.<org.robotui.geometry.RigidTransform>empty() : placer.latest(base).found())
        .or(() -> placer.latest(e.value().frame()).found().map(t -> t.times(e.value().pose())))
        .map(t -> t.translation());
  }

  private static boolean isMoving(Odometry o) {
    return Math.hypot(o.linear().x(), o.linear().y()) > MOVING || Math.abs(o.angular().z()) > TURNING;
  }

  private static <T extends Data> Optional<Envelope<T>> newest(Input<T> input, Member member) {
    return input.sources().stream().filter(member::has).findFirst().flatMap(input::latest);
  }
}
