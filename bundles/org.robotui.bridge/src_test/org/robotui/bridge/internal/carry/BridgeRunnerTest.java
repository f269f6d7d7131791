package org.robotui.bridge.internal.carry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.robotui.api.bridge.BridgeStatus.State;
import org.robotui.api.port.RawMessage;
import org.robotui.api.port.SourceId;
import org.robotui.data.FrameId;
import org.robotui.data.array.Bytes;
import org.robotui.data.array.Floats;
import org.robotui.data.command.RelayMessage;
import org.robotui.data.command.VelocityCommand;
import org.robotui.data.geometry.StampedPose;
import org.robotui.data.navigation.GridMap;
import org.robotui.data.navigation.NavigationGoal;
import org.robotui.data.record.FieldValue;
import org.robotui.data.record.MapRecord;
import org.robotui.data.sensor.LaserScan;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.testkit.FakeAuthority;

class BridgeRunnerTest {
  private static final VelocityCommand FAST = new VelocityCommand(new Vector3(2, 0, 0), Vector3.ZERO);
  private static final MapRecord NOTE = new MapRecord("demo/Note", Map.of("number", new FieldValue.Num(3, "3")));

  private final TwoRobots robots = new TwoRobots();

  @AfterEach
  void end() {
    robots.close();
  }

  private static LaserScan scan() {
    return new LaserScan(new FrameId("Natalie", "laser"), 0, 0.1, 0.1, 10, 0.1, Floats.of(1, 2), Floats.EMPTY);
  }

  @Test
  void a_scan_passes_without_a_lease_and_belongs_to_the_other_robot() {
    robots.bridge("natalie/scan", Map.of("frame_prefix", "natalie/"));
    robots.says(scan());
    TwoRobots.await(() -> !robots.heard(RelayMessage.class).isEmpty());

    RelayMessage heard = robots.heard(RelayMessage.class).getFirst();
    assertEquals("natalie/scan", heard.topic());
    assertEquals(new FrameId("Keira", "natalie/laser"), ((LaserScan) heard.value()).frame());
    assertTrue(heard.stamp().isPresent(), "a value without a stamp is as old as its reception");
    assertFalse(heard.guarded());
    assertEquals(Optional.empty(), robots.keira.authority().holder());
    TwoRobots.await(() -> robots.status().state() == State.CARRYING);
  }

  @Test
  void every_value_passes_in_order() {
    robots.bridge("notes", Map.of("lease", false));
    for (int i = 0; i < 60; i++) {
      robots.says(new MapRecord("demo/Note", Map.of("number", new FieldValue.Num(i, Integer.toString(i)))));
    }
    TwoRobots.await(() -> robots.heard(RelayMessage.class).size() == 60);

    List<String> numbers = robots.heard(RelayMessage.class).stream()
        .map(m -> ((FieldValue.Num) ((MapRecord) m.value()).field("number").orElseThrow()).exact()).toList();
    assertEquals(java.util.stream.IntStream.range(0, 60).mapToObj(Integer::toString).toList(), numbers);
    assertEquals(0, robots.status().counts().dropped());
  }

  @Test
  void a_rate_leaves_out_what_is_older_and_says_so() {
    robots.bridge("natalie/scan", Map.of("rate", 0.01));
    for (int i = 0; i < 50; i++) {
      robots.says(scan());
    }
    TwoRobots.await(() -> robots.status().counts().received() == 50 && robots.status().counts().passed() > 0);

    assertTrue(robots.heard(RelayMessage.class).size() <= 2, "one, and one more where the first was alone");
    TwoRobots.await(() -> robots.status().counts().thinned() >= 48 - 1);
  }

  @Test
  void what_does_not_meet_the_condition_is_left_out_and_counted() {
    robots.bridge("notes", Map.of("lease", false, "when", "said number >= 8 and said number != 9"));
    for (int i = 0; i < 12; i++) {
      robots.says(new MapRecord("demo/Note", Map.of("number", new FieldValue.Num(i, Integer.toString(i)))));
    }
    TwoRobots.await(() -> robots.heard(RelayMessage.class).size() == 3);
    TwoRobots.await(() -> robots.status().counts().thinned() == 9);
  }

  @Test
  void a_condition_about_what_is_not_there_says_so() {
    robots.bridge("notes", Map.of("lease", false, "when", "said charge > 0.2"));
    robots.says(NOTE);
    robots.awaitText("'when': ");
    assertEquals(State.REFUSED, robots.status().state());
  }

  private Optional<RelayMessage.Wire> wire(Map<String, Object> settings) {
    robots.bridge("notes", settings);
    robots.natalie.ports().put(new SourceId("base", "said"), NOTE, Optional.empty(),
        Optional.of(new RawMessage("demo/Note", "ros1", Bytes.of((byte) 3), bytes -> Optional.of(NOTE))));
    TwoRobots.await(() -> !robots.heard(RelayMessage.class).isEmpty());
    return robots.heard(RelayMessage.class).getFirst().original().wire();
  }

  @Test
  void a_message_in_which_nothing_changes_brings_its_bytes() {
    assertEquals(Optional.of(Bytes.of((byte) 3)), wire(Map.of("lease", false)).map(RelayMessage.Wire::bytes));
  }

  @Test
  void a_message_with_other_frames_does_not_bring_its_bytes() {
    assertEquals(Optional.empty(), wire(Map.of("lease", false, "frame_prefix", "natalie/")));
  }

  @Test
  void values_lost_before_the_bridge_are_counted() {
    robots.bridge("natalie/scan", Map.of());
    robots.says(scan());
    TwoRobots.await(() -> robots.heard(RelayMessage.class).size() == 1);
    robots.at(robots.natalie).drop(new SourceId("base", "said"), 3);
    robots.says(scan());

    TwoRobots.await(() -> robots.status().counts().dropped() == 3);
  }

  @Test
  void a_motion_takes_the_lease_keeps_limits_and_gives_the_lease_back_at_the_end() {
    robots.bridge("cmd_vel", Map.of("max_linear", 0.5));
    robots.says(FAST);
    TwoRobots.await(() -> !robots.heard(VelocityCommand.class).isEmpty());

    assertEquals(0.5, robots.heard(VelocityCommand.class).getFirst().linear().x(), 1e-9);
    assertEquals("Bridge test", robots.keira.authority().holder().orElseThrow().label());
    robots.close();
    assertEquals(Optional.empty(), robots.keira.authority().holder());
    assertTrue(robots.keira.ports().sent().contains("release"));
  }

  @Test
  void nothing_moves_because_a_stop_was_released() {
    robots.bridge("cmd_vel", Map.of());
    robots.says(FAST);
    TwoRobots.await(() -> robots.heard(VelocityCommand.class).size() == 1);
    robots.keira.authority().stop(FakeAuthority.ANNA);
    robots.saysUntilText(FAST, "stopped by Anna");
    robots.keira.authority().releaseStop(FakeAuthority.ANNA);
    robots.saysUntilText(FAST, "have not paused");
    assertEquals(1, robots.heard(VelocityCommand.class).size());

    robots.says(FAST.stopped());
    robots.says(FAST);
    TwoRobots.await(() -> robots.heard(VelocityCommand.class).size() == 3);
  }

  @Test
  void control_of_somebody_else_is_not_taken() {
    robots.keira.authority().take(FakeAuthority.ANNA, false);
    robots.bridge("cmd_vel", Map.of());
    robots.says(FAST);

    robots.awaitText("Anna has control of Keira");
    assertEquals(FakeAuthority.ANNA, robots.keira.authority().holder().orElseThrow());
    assertEquals(1, robots.status().counts().refused());
  }

  @Test
  void what_is_not_known_to_command_nothing_needs_the_lease() {
    robots.bridge("notes", Map.of());
    robots.keira.authority().stop(FakeAuthority.ANNA);
    robots.says(NOTE);
    robots.awaitText("stopped by Anna");
    assertEquals(List.of(), robots.heard(RelayMessage.class));
  }

  @Test
  void a_pose_is_a_goal_where_goals_are_taken() {
    robots.bridge("goal", Map.of());
    robots.says(new StampedPose(new FrameId("Natalie", "map"), RigidTransform.IDENTITY));
    TwoRobots.await(() -> !robots.heard(NavigationGoal.class).isEmpty());
    assertEquals(new FrameId("Keira", "map"), robots.heard(NavigationGoal.class).getFirst().frame());
  }

  @Test
  void fields_make_a_velocity_where_velocities_are_taken() {
    robots.bridge("cmd_vel", Map.of("max_linear", 0.5, "fields", Map.of("linear.x", "number", "angular.z", "0.2")));
    robots.says(NOTE);
    TwoRobots.await(() -> !robots.heard(VelocityCommand.class).isEmpty());
    VelocityCommand heard = robots.heard(VelocityCommand.class).getFirst();
    assertEquals(0.5, heard.linear().x(), 1e-9);
    assertEquals("Bridge test", robots.keira.authority().holder().orElseThrow().label());
  }

  @Test
  void what_a_port_does_not_take_is_refused_with_what_it_takes() {
    robots.bridge("cmd_vel", Map.of());
    robots.says(scan());
    robots.awaitText("takes VelocityCommand, not LaserScan");
  }

  @Test
  void fields_make_another_message() {
    robots.bridge("NUMBERS", Map.of("type", "demo.number_t", "lease", false,
        "fields", Map.of("inner.millis", "number * 1000 + 5", "unit", "'mm'")));
    robots.says(NOTE);
    TwoRobots.await(() -> !robots.heard(RelayMessage.class).isEmpty());

    RelayMessage heard = robots.heard(RelayMessage.class).getFirst();
    assertEquals(RelayMessage.Original.NONE, heard.original());
    assertEquals(Map.of("inner", Map.of("millis", 3005L), "unit", "mm"),
        org.robotui.data.record.RecordTree.of((MapRecord) heard.value()));
  }

  @Test
  void a_field_that_is_not_there_is_named_with_those_that_are() {
    robots.bridge("NUMBERS", Map.of("fields", Map.of("a", "count")));
    robots.says(NOTE);
    robots.awaitText("demo/Note has no 'count' for the field 'a'; it has number");
  }

  @Test
  void a_map_is_said_again_to_a_robot_that_comes_later() {
    robots.bridge("map", Map.of());
    robots.at(robots.keira).withdraw("base");
    robots.awaitText("nothing can be sent");
    robots.says(new GridMap(new FrameId("Natalie", "map"), 0.1, 1, 1, RigidTransform.IDENTITY, Bytes.of((byte) 0)));
    TwoRobots.await(() -> robots.status().counts().refused() == 1);
    TwoRobots.offerCommands(robots.keira);

    TwoRobots.await(() -> robots.heard(RelayMessage.class).size() == 1);
    assertTrue(robots.heard(RelayMessage.class).getFirst().kept());
  }

  @Test
  void an_unknown_transform_is_told_with_those_that_are_there() {
    robots.bridge("goal", Map.of("transform", "nonsense"));
    robots.awaitText("no transform 'nonsense' is installed");
    assertEquals(State.WRONG, robots.status().state());
  }

  @Test
  void a_robot_ui_that_does_not_run_is_named() {
    robots.host.remove(robots.natalie);
    robots.bridge("goal", Map.of());
    robots.awaitText("the robot UI 'Natalie' does not run");
  }
}
