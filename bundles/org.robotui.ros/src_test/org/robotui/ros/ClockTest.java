package org.robotui.ros;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.Test;
import org.robotui.message.MessageInfo;
import org.robotui.message.MessageWriter;
import org.robotui.message.RawCodec;
import org.robotui.message.RawMessage;

class ClockTest {

  private static final MessageInfo CLOCK =
      new MessageInfo("rosgraph_msgs/Clock", "a9c97c1d230cfc112e270351a944ee47", "time clock\n");

  private static RawMessage clock(int seconds) {
    return new RawMessage(CLOCK, new MessageWriter().time(seconds, 500).view());
  }

  @Test
  void simulatedTimeFollowsTheClockTopicAndTellsOfJumpsBack() throws Exception {
    try (Graph graph = new Graph()) {
      RosNode node = graph.node("node");
      RosNode simulator = graph.node("simulator");
      List<String> jumps = new CopyOnWriteArrayList<>();
      node.clock().onJumpBack((from, to) -> jumps.add(from + ">" + to));
      long now = System.currentTimeMillis();
      assertTrue(Math.abs(node.clock().nowNanos() / 1_000_000 - now) < 5_000);
      assertFalse(node.clock().isSimulated());
      assertTrue(node.awaitRegistered(java.time.Duration.ofSeconds(30)));
      simulator.parameters().set("/use_sim_time", XmlRpcValue.of(true));
      Publisher<RawMessage> publisher = simulator.publisher("/clock", new RawCodec(CLOCK), PublisherOptions.standard());
      Eventually.await("the simulated time", () -> {
        publisher.publish(clock(100));
        return node.clock().nowNanos() == 100_000_000_500L;
      });
      publisher.publish(clock(40));
      Eventually.await("the jump", () -> jumps.equals(List.of("100000000500>40000000500")));
      simulator.parameters().set("/use_sim_time", XmlRpcValue.of(false));
      Eventually.await("wall time again", () -> !node.clock().isSimulated());
    }
  }
}
