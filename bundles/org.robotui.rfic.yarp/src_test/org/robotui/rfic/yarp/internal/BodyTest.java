package org.robotui.rfic.yarp.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.api.config.Placed;
import org.robotui.api.config.Settings;
import org.robotui.api.port.CommandSink;
import org.robotui.data.Data;
import org.robotui.data.joint.JointCommand;
import org.robotui.data.joint.JointControl;
import org.robotui.data.joint.JointMode;
import org.robotui.data.joint.JointModel;
import org.robotui.data.joint.JointState;
import org.robotui.data.joint.RobotDescription;
import org.robotui.yarp.bottle.Bottle;
import org.robotui.yarp.bottle.YarpValue;
import org.robotui.yarp.port.PortArrival;

/** A robot of several control boards as one set of joints. */
@Timeout(120)
class BodyTest {
  private static final String ARM = "/robby/arm";
  private static final String HEAD = "/robby/head";

  private final List<String> told = new CopyOnWriteArrayList<>();
  private YarpRobot robot;
  @TempDir
  private Path folder;

  @BeforeEach
  void begin() throws IOException {
    robot = new YarpRobot();
    Files.writeString(folder.resolve("robby.urdf"), "<robot name='robby'><link name='trunk'/></robot>");
    Files.writeString(folder.resolve("robby.srdf"), "<robot name='robby'/>");
    board(HEAD, List.of("yaw", "pitch"));
    board(ARM, List.of("elbow", "yaw"));
    robot.look(Map.of("prefix", "/robby", "urdf", Placed.nowhere(folder.resolve("robby.urdf").toString())));
    List.of("joints", "control", "model").forEach(port -> {
      robot.await(port + " is offered", () -> robot.context.streams.containsKey(port));
      robot.context.demand(port, true);
    });
  }

  @AfterEach
  void end() {
    robot.close();
  }

  private void board(String device, List<String> joints) throws IOException {
    robot.says(device + "/state:o");
    robot.open(device + "/rpc:i", arrival -> Optional.of(answer(device, joints, arrival)));
  }

  private Bottle answer(String device, List<String> joints, PortArrival arrival) {
    Bottle question = arrival.bottle();
    String what = question.get(1).text();
    if (question.get(0).text().equals("set")) {
      told.add(device + " " + question);
      return Bottle.of(Bottle.vocabs("ok"));
    }
    List<YarpValue> answer = new ArrayList<>(List.of(YarpValue.Vocab.of("is"), question.get(1)));
    switch (what) {
      case "axes" -> answer.addAll(Bottle.of(joints.size()).values());
      case "name" -> answer.addAll(Bottle.of(joints.get((int) question.get(2).number())).values());
      case "type" -> answer.addAll(Bottle.vocabs("atrv"));
      default -> answer.addAll(Bottle.reals(-90, 90).values());
    }
    answer.addAll(Bottle.vocabs("ok"));
    return Bottle.of(answer);
  }

  private Data newest(String port) {
    return robot.context.published.get(port).peekLast().value();
  }

  private static List<String> names(Data joints) {
    return ((JointState) joints).joints().stream().map(JointState.Joint::name).toList();
  }

  /** The boards say where they are until all joints have arrived. */
  private void whole() {
    robot.await("joints of both boards", () -> {
      robot.say(HEAD + "/state:o", Bottle.reals(10, 20));
      robot.say(ARM + "/state:o", Bottle.reals(30, 40));
      return List.of("joints", "control").stream().allMatch(
          port -> Optional.ofNullable(robot.context.published.get(port)).filter(all -> !all.isEmpty()).isPresent())
          && names(newest("joints")).size() == 4;
    });
  }

  @Test
  void joints_of_all_boards_are_one_set() {
    whole();
    assertEquals(Set.of("head/yaw", "pitch", "elbow", "arm/yaw"), Set.copyOf(names(newest("joints"))),
        "names that two boards use have the board's name before them");
    JointState.Joint elbow = ((JointState) newest("joints")).joints().stream().filter(j -> j.name().equals("elbow"))
        .findFirst().orElseThrow();
    assertEquals(Math.toRadians(30), elbow.position(), 1e-9);
    robot.await("how all are driven", () -> ((JointControl) newest("control")).joints().size() == 4);
    robot.await("the limits of all", () -> ((JointModel) newest("model")).joints().size() == 4);
    JointModel model = (JointModel) newest("model");
    assertEquals(Set.of("head", "arm"), Set.copyOf(model.chains().stream().map(JointModel.Chain::name).toList()));
    assertEquals(List.of(0, 1, 2, 3), model.joints().stream().map(JointModel.Joint::id).toList());
    assertEquals(Math.toRadians(90), model.joints().getFirst().upper(), 1e-9);
  }

  @Test
  @SuppressWarnings("unchecked")
  void one_command_drives_several_boards_and_one_stop_halts_them() {
    whole();
    CommandSink<Data> body = (CommandSink<Data>) robot.context.sinks.get("joint_command");
    assertInstanceOf(CommandSink.Sent.Refused.class, body.send(positions("knee")));
    assertEquals(new CommandSink.Sent.Unneeded(), body.stop(JointCommand.ZERO, false), "nothing was driven from here");
    JointCommand.Joint turning = new JointCommand.Joint("head/yaw",
        new JointControl.Reference(0, Math.toRadians(5), 0, 0, 0), Set.of(JointMode.VELOCITY));
    assertEquals(new CommandSink.Sent.Out(),
        body.send(new JointCommand(List.of(turning, positions("elbow").joints().getFirst()))));
    robot.await("both are told", () -> told.stream().anyMatch(t -> t.startsWith(HEAD + " [set] [vmo] 0 5"))
        && told.stream().anyMatch(t -> t.startsWith(ARM + " [set] [pos] 0 1")));
    assertTrue(told.contains(HEAD + " [set] [icmd] [cmod] 0 [vel]"), () -> "the mode comes first: " + told);
    assertEquals(new CommandSink.Sent.Out(), body.stop(JointCommand.ZERO, true));
    robot.await("both are halted", () -> told.contains(HEAD + " [set] [vmo] 0 0.0")
        && told.contains(ARM + " [set] [sto] 0"));
  }

  private static JointCommand positions(String joint) {
    return new JointCommand(List.of(JointCommand.position(joint, Math.toRadians(10))));
  }

  @Test
  void a_file_says_how_the_robot_is_built() {
    robot.await("the description", () -> robot.context.published.containsKey("robot_description"));
    RobotDescription description = (RobotDescription) newest("robot_description");
    assertTrue(description.urdf().contains("trunk") && !description.srdf().isEmpty());
    Settings settings = new Settings(YarpSettings.SCHEMA,
        Map.of("urdf", new Placed("absent.urdf", folder.resolve("robots.yaml").toString(), 7, 3)));
    assertTrue(new YarpRficType().faults(settings).getFirst().toString().contains("absent.urdf is no file"));
  }
}
