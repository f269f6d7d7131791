package org.robotui.uic.team.internal;

import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.host.ComponentStatus;
import org.robotui.api.host.RuicSnapshot;
import org.robotui.api.host.RuicState;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.Input;
import org.robotui.api.port.InputState;
import org.robotui.api.port.SourceId;
import org.robotui.data.FrameId;
import org.robotui.data.array.Doubles;
import org.robotui.data.navigation.Odometry;
import org.robotui.data.record.FieldValue;
import org.robotui.data.record.MapRecord;
import org.robotui.data.sensor.Battery;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.testkit.FakeAuthority;
import org.robotui.testkit.FakeFrames;
import org.robotui.testkit.FakeUicContext;

/** A team of robots r1, r2 and so on, in a test's hands. */
public final class Squad {
  public final FakeUicContext context = new FakeUicContext("team", new TeamType().schema());
  private final Map<String, FakeAuthority> robots = new LinkedHashMap<>();
  private final Map<String, LinkState> links = new LinkedHashMap<>();

  /** With so many robots, all connected, none of which has said anything. */
  public Squad(int count) {
    for (int i = 1; i <= count; i++) {
      robots.put("base" + i, new FakeAuthority("r" + i));
      links.put("base" + i, new LinkState.Connected("localhost:11311"));
    }
    context.frames(new FakeFrames());
    context.ruic().team(robots);
    context.output(TeamPorts.VELOCITY).targets(robots.keySet().stream().map(c -> new SourceId(c, "cmd_vel")).toList());
    tell();
  }

  private void tell() {
    List<ComponentStatus> all = new ArrayList<>();
    links.forEach(
        (id, link) -> all.add(new ComponentStatus(id, id.endsWith("2") ? "player" : "ros", ComponentStatus.Kind.RFIC,
            RuicState.SELECTED, "", Optional.of(link))));
    context.ruic().snapshot(
        new RuicSnapshot("Team", RuicState.SELECTED, "", new LinkState.Connected(""), all, List.of(), List.of()));
  }

  public FakeAuthority robot(int number) {
    return robots.get("base" + number);
  }

  public Squad lose(int number) {
    links.put("base" + number,
        new LinkState.Failed("r" + number + ":11311 refuses the connection", Duration.ofSeconds(4)));
    tell();
    return this;
  }

  public Squad drives(int number, double x, double y, double speed) {
    FrameId odom = new FakeFrame(number).odom();
    Odometry odometry = new Odometry(odom, new FrameId(odom.robot(), ""), RigidTransform.planar(x, y, 0), Doubles.EMPTY,
        new Vector3(speed, 0, 0), Vector3.ZERO, Doubles.EMPTY);
    context.input(TeamPorts.ODOM).put(source(number, "odom"), odometry, System.nanoTime(), Optional.empty());
    return this;
  }

  private record FakeFrame(int number) {
    FrameId odom() {
      return new FrameId("r" + number, "odom");
    }
  }

  public Squad is(int number, InputState state) {
    context.input(TeamPorts.ODOM).state(source(number, "odom"), state);
    return this;
  }

  public Squad charged(int number, double charge) {
    context.input(TeamPorts.BATTERY).put(source(number, "battery"),
        new Battery(24, -1, charge, Battery.Status.DISCHARGING), System.nanoTime(),
        Optional.empty());
    return this;
  }

  public Squad does(int number, int status, String text) {
    SourceId source = source(number, "move_base/status");
    MapRecord goal = new MapRecord("actionlib_msgs/GoalStatus",
        Map.of("status", new FieldValue.Num(status, Integer.toString(status)),
            "text", new FieldValue.Text(text)));
    List<Input.Candidate> known = new ArrayList<>(context.input(TeamPorts.TASK).candidates());
    known.add(new Input.Candidate(source, "DynamicRecord"));
    known.add(new Input.Candidate(source(number, "other/state"), "DynamicRecord"));
    context.input(TeamPorts.TASK).candidates(known);
    context.input(TeamPorts.TASK).put(source, new MapRecord("actionlib_msgs/GoalStatusArray",
        Map.of("status_list", new FieldValue.Items(List.of(new FieldValue.Nested(goal))))), System.nanoTime(),
        Optional.empty());
    return this;
  }

  public static SourceId source(int number, String port) {
    return new SourceId("base" + number, port);
  }
}
