package org.robotui.ros2.internal.type;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.message.Generation;
import org.robotui.message.LocalDefinitions;
import org.robotui.message.MessageSchema;
import org.robotui.message.SchemaLookup;
import org.robotui.message.description.TypeDescription;
import org.robotui.message.description.TypeHash;
import org.robotui.message.description.TypeName;
import org.robotui.message.description.TypeRegistry;
import org.robotui.ros2.RclpyRobot;
import org.robotui.ros2.Ros2Environment;
import org.robotui.ros2.graph.GraphEnd;
import org.robotui.ros2.internal.graph.GraphKeeper;
import org.robotui.ros2.internal.link.Ends;
import org.robotui.ros2.name.Ros2Name;
import org.robotui.rtps.Participant;

/** Asks a robot that is not ours what its messages are. */
class DescriptionTest {

  private static final int DOMAIN = 171 + (int) (ProcessHandle.current().pid() % 10);
  private static final Ros2Name BATTERY = Ros2Name.of("/robot/battery");
  private static final TypeName TYPE = TypeName.parse("sensor_msgs/msg/BatteryState").orElseThrow();

  @Test
  void aNodeDescribesWhatItPublishes() throws Exception {
    assumeTrue(RclpyRobot.python().isPresent(), "rclpy is not installed (ROBOTUI_ROS2_PEERS)");
    TypeRegistry registry = new TypeRegistry(new LocalDefinitions(List.of(), List.of(), Generation.ROS2));
    try (RclpyRobot robot = new RclpyRobot(DOMAIN);
        Participant participant =
            Participant.open(Ros2Environment.local(DOMAIN).participant(Optional.empty()), Thread::new)) {
      GraphKeeper graph = new GraphKeeper(participant);
      robot.await("its topic", () -> graph.state().topic(BATTERY).isPresent());
      TypeHash hash = ends(graph).get(0).hash().orElseThrow();
      DescriptionClient client = new DescriptionClient(new Ends(participant, graph, Ros2Name.of("/n")), registry);
      assertEquals(Optional.empty(), client.ask(TYPE, hash, () -> ends(graph), Duration.ofSeconds(20)));
      MessageSchema learned = ((SchemaLookup.Found<MessageSchema>) registry.message(TYPE, Optional.of(hash))).schema();
      assertEquals(hash, TypeDescription.of(TYPE, learned).hash());
      assertFalse(learned.definition().constants().isEmpty(), "the sources have constants");
      assertEquals(Optional.of("/robot/base: asked for odd_msgs/msg/Odd, a node described another type"),
          client.ask(TypeName.parse("odd_msgs/msg/Odd").orElseThrow(), hash, () -> ends(graph),
              Duration.ofSeconds(20)));
    }
  }

  private static List<GraphEnd> ends(GraphKeeper graph) {
    return graph.state().topic(BATTERY).orElseThrow().publishers();
  }
}
