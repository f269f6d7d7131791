package org.robotui.ros.internal.node;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicInteger;
import javax.net.SocketFactory;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.robotui.message.RecordCodec;
import org.robotui.message.ros.std_msgs.StdString;
import org.robotui.ros.GraphName;
import org.robotui.ros.NodeOptions;
import org.robotui.ros.PublisherOptions;
import org.robotui.ros.RosEnvironment;
import org.robotui.ros.RosNode;
import org.robotui.ros.Subscriber;
import org.robotui.ros.SubscriberOptions;
import org.robotui.ros.SystemState;
import org.robotui.ros.master.MasterOptions;
import org.robotui.ros.master.RosMaster;

/** What a node leaves to be said to its master, said by somebody else. */
@Timeout(30)
class FarewellsTest {
  private final Map<Integer, byte[]> left = new ConcurrentHashMap<>();
  private final AtomicInteger ids = new AtomicInteger();
  private RosMaster master;
  private RosNode node;

  @BeforeEach
  void open() throws IOException {
    master = RosMaster.open(MasterOptions.standard(Thread::new));
    node = RosNode.open(
        RosEnvironment.of(Map.of("ROS_MASTER_URI", master.uri().toString(), "ROS_IP", "127.0.0.1"), List.of()),
        GraphName.of("/careful"), NodeOptions.standard(Thread::new).withCare(SocketFactory.getDefault(), this::leave));
  }

  @AfterEach
  void close() {
    node.close();
    master.close();
  }

  private Runnable leave(InetSocketAddress to, byte[] words) {
    assertEquals(master.uri().getPort(), to.getPort());
    int id = ids.incrementAndGet();
    left.put(id, words);
    return () -> left.remove(id);
  }

  private void sayAll() throws IOException {
    for (byte[] words : left.values()) {
      try (Socket socket = new Socket("127.0.0.1", master.uri().getPort())) {
        socket.setSoTimeout(5000);
        socket.getOutputStream().write(words);
        String answer = new String(socket.getInputStream().readAllBytes(), StandardCharsets.UTF_8); // to the end: the
                                                                                                    // master closes
        assertTrue(answer.startsWith("HTTP/1.1 200"), answer);
      }
    }
  }

  private SystemState state() {
    return node.master().systemState().toOptional().orElseThrow();
  }

  @Test
  void the_master_forgets_what_is_said_to_it_and_is_told_again_by_a_node_that_lives() throws Exception {
    node.publisher("/said", RecordCodec.of(StdString.class), PublisherOptions.standard());
    node.subscriber("/heard", RecordCodec.of(StdString.class), SubscriberOptions.standard(), (value, reception) -> {});
    assertTrue(node.awaitRegistered(Duration.ofSeconds(30)));
    assertEquals(List.of("/careful"), state().publishers().get("/said"));
    assertEquals(List.of("/careful"), state().subscribers().get("/heard"));

    sayAll();

    assertEquals(null, state().publishers().get("/said"));
    assertEquals(null, state().subscribers().get("/heard"));
    long end = System.nanoTime() + Duration.ofSeconds(60).toNanos();
    while (!state().subscribers().containsKey("/heard") || !state().publishers().containsKey("/said")) {
      assertTrue(System.nanoTime() < end, "it registers again");
      Thread.sleep(50);
    }
  }

  @Test
  void nothing_is_left_of_what_the_node_ended_itself() throws Exception {
    Subscriber subscriber = node.subscriber("/heard", RecordCodec.of(StdString.class), SubscriberOptions.standard(),
        (value, reception) -> {});
    assertTrue(node.awaitRegistered(Duration.ofSeconds(30)));
    int before = left.size();
    subscriber.close();
    assertTrue(node.awaitRegistered(Duration.ofSeconds(30)));
    assertEquals(before - 1, left.size());
    node.close();
    assertEquals(Map.of(), left);
  }
}
