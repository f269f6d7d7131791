package org.robotui.ros.internal.node;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.message.RecordCodec;
import org.robotui.message.ros.std_msgs.StdString;
import org.robotui.message.ros.std_srvs.EmptyResponse;
import org.robotui.net.socket.HostPort;
import org.robotui.net.process.RunningProcess;
import org.robotui.ros.Eventually;
import org.robotui.ros.Graph;
import org.robotui.ros.PublisherOptions;
import org.robotui.ros.RosEnvironment;
import org.robotui.ros.RosNode;
import org.robotui.ros.StaleRegistrations;
import org.robotui.ros.SubscriberOptions;
import org.robotui.ros.SystemState;
import org.robotui.ros.XmlRpcValue;
import org.robotui.ros.internal.xmlrpc.XmlRpcClient;
import org.robotui.ros.internal.xmlrpc.XmlRpcLimits;
import org.robotui.ros.msgs.StandardServices;

/** Registrations of a node whose process is gone, and of others that must stay. */
class LeftoversTest {

  private static final Duration TIME = Duration.ofSeconds(10);
  private static final String DEAD_URI = "http://127.0.0.1:9/";
  private static final String DEAD_RPC = "rosrpc://127.0.0.1:9";

  @TempDir
  private Path folder;
  private Graph graph;
  private RosNode witness;
  private Owner gone;

  @BeforeEach
  void start() throws Exception {
    graph = new Graph();
    witness = graph.node("witness");
    witness.publisher("/chatter", RecordCodec.of(StdString.class), PublisherOptions.standard());
    assertTrue(witness.awaitRegistered(TIME));
    Process ended = new ProcessBuilder("true").start();
    assertEquals(0, ended.waitFor());
    gone = new Owner(Owner.current().host(), new RunningProcess(ended.pid(), Instant.now()));
  }

  @AfterEach
  void stop() {
    graph.close();
  }

  private void register(String method, String... arguments) throws Exception {
    HostPort master = HostPort.ofUri(graph.master().uri().toString(), "http");
    try (XmlRpcClient client = new XmlRpcClient(master, XmlRpcLimits.standard().withMessage(Duration.ofSeconds(5)))) {
      client.call(method, Stream.of(arguments).map(XmlRpcValue::of).toList());
    }
  }

  private void registerAll(String uri) throws Exception {
    register("registerPublisher", "/dead", "/chatter", "std_msgs/String", uri);
    register("registerSubscriber", "/dead", "/other", "std_msgs/String", uri);
    register("registerService", "/dead", "/dead/switch", DEAD_RPC, uri);
    register("subscribeParam", "/dead", uri, "/use_sim_time");
  }

  private Path record(Owner owner, String master) throws Exception {
    Path file = folder.resolve("node-1-2" + NodeRecord.SUFFIX);
    new NodeRecord("/dead", DEAD_URI, DEAD_RPC, master, owner, List.of("/use_sim_time")).write(file);
    return file;
  }

  private String master() {
    return graph.master().uri().toString();
  }

  private SystemState state() {
    return witness.master().systemState().toOptional().orElseThrow();
  }

  @Test
  void allThatADeadNodeLeftIsRemovedAndNothingElse() throws Exception {
    registerAll(DEAD_URI);
    Path file = record(gone, master());
    assertEquals(new StaleRegistrations.Cleared(List.of("/dead"), true), StaleRegistrations.clear(folder, TIME));
    assertFalse(state().nodes().contains("/dead"), state().toString());
    assertEquals(List.of("/witness"), state().publishers().get("/chatter"));
    assertFalse(Files.exists(file));
    assertEquals(new StaleRegistrations.Cleared(List.of(), true), StaleRegistrations.clear(folder, TIME));
  }

  @Test
  void aNodeThatTookTheNameIsNotTouched() throws Exception {
    registerAll("http://127.0.0.1:10/");
    Path file = record(gone, master());
    assertEquals(new StaleRegistrations.Cleared(List.of(), true), StaleRegistrations.clear(folder, TIME));
    assertEquals(List.of("/dead"), state().services().get("/dead/switch"));
    assertTrue(state().publishers().get("/chatter").contains("/dead"));
    assertFalse(Files.exists(file));
  }

  @Test
  void aNodeOfALivingProcessOrOfAnotherMachineIsNotTouched() throws Exception {
    registerAll(DEAD_URI);
    for (Owner other : List.of(Owner.current(), new Owner("elsewhere", gone.process()))) {
      Path file = record(other, master());
      assertEquals(new StaleRegistrations.Cleared(List.of(), true), StaleRegistrations.clear(folder, TIME));
      assertTrue(state().nodes().contains("/dead"));
      assertTrue(Files.exists(file));
    }
  }

  @Test
  void aProcessThatGotTheNumberOfTheDeadOneDoesNotProtectIt() throws Exception {
    registerAll(DEAD_URI);
    Owner same = Owner.current();
    record(
        new Owner(same.host(), new RunningProcess(same.process().pid(), same.process().started().minusSeconds(3600))),
        master());
    assertEquals(new StaleRegistrations.Cleared(List.of("/dead"), true), StaleRegistrations.clear(folder, TIME));
  }

  @Test
  void aNodeThatAnswersIsNotTouchedWhateverTheProcessTableSays() throws Exception {
    Owner same = Owner.current();
    Path file = folder.resolve("node-1-3" + NodeRecord.SUFFIX);
    new NodeRecord("/witness", witness.uri(), DEAD_RPC, master(),
        new Owner(same.host(), new RunningProcess(same.process().pid(), Instant.EPOCH)),
        List.of()).write(file);
    assertEquals(new StaleRegistrations.Cleared(List.of(), true), StaleRegistrations.clear(folder, TIME));
    assertEquals(List.of("/witness"), state().publishers().get("/chatter"));
    assertTrue(Files.exists(file));
  }

  @Test
  void aMasterThatIsAwayIsTriedAgain() throws Exception {
    registerAll(DEAD_URI);
    Path file = record(gone, "http://127.0.0.1:9/");
    assertEquals(new StaleRegistrations.Cleared(List.of(), false), StaleRegistrations.clear(folder, TIME));
    assertTrue(Files.exists(file));
    record(gone, master());
    assertEquals(new StaleRegistrations.Cleared(List.of("/dead"), true), StaleRegistrations.clear(folder, TIME));
  }

  @Test
  void aNodeIsNotedWhileItIsRegisteredAndNoLonger() throws Exception {
    RosNode node = graph.open(RosEnvironment.of(graph.master().uri()), "noted",
        graph.options().withRecords(folder.resolve("new/state")));
    node.subscriber("/other", RecordCodec.of(StdString.class), SubscriberOptions.standard(), (text, from) -> {});
    node.serviceServer("~s", StandardServices.EMPTY, (request, caller) -> new EmptyResponse());
    node.parameters().subscribe("/limits", (key, value) -> {});
    assertTrue(node.awaitRegistered(TIME));
    NodeRecord note = NodeRecord.read(only(folder.resolve("new/state")));
    assertEquals("/noted", note.node());
    assertEquals(node.uri(), note.uri());
    assertEquals(List.of("/limits", "/use_sim_time"), note.parameters());
    assertTrue(note.owner().process().runs() && note.owner().isOnThisHost());
    assertEquals(new StaleRegistrations.Cleared(List.of(), true),
        StaleRegistrations.clear(folder.resolve("new/state"), TIME));
    node.close();
    try (Stream<Path> files = Files.list(folder.resolve("new/state"))) {
      assertEquals(List.of(), files.toList());
    }
  }

  private static Path only(Path folder) throws Exception {
    try (Stream<Path> files = Files.list(folder)) {
      List<Path> all = files.toList();
      assertEquals(1, all.size(), all.toString());
      return all.get(0);
    }
  }

  @Test
  void aNodeThatTheMasterCouldNotForgetStaysNoted() throws Exception {
    RosNode node = graph.open(RosEnvironment.of(graph.master().uri()), "noted", graph.options().withRecords(folder));
    node.publisher("/other", RecordCodec.of(StdString.class), PublisherOptions.standard());
    assertTrue(node.awaitRegistered(TIME));
    graph.master().close();
    node.close();
    assertTrue(Files.exists(only(folder)));
  }

  @Test
  void damagedNotesAreRemovedAndHarmNothing() throws Exception {
    SplittableRandom random = new SplittableRandom(2026);
    byte[] good = Files.readAllBytes(record(gone, "http://127.0.0.1:9/"));
    for (int round = 0; round < 200; round++) {
      byte[] bad = good.clone();
      for (int i = 0; i < 30; i++) {
        bad[random.nextInt(bad.length)] = (byte) random.nextInt();
      }
      Files.write(folder.resolve("node-" + round + NodeRecord.SUFFIX), bad);
    }
    Files.write(folder.resolve("node-long" + NodeRecord.SUFFIX), new byte[100_000]);
    Files.writeString(folder.resolve("other.txt"), "not ours");
    assertEquals(List.of(), StaleRegistrations.clear(folder, Duration.ofSeconds(30)).nodes());
    assertFalse(Files.exists(folder.resolve("node-long" + NodeRecord.SUFFIX)));
    assertTrue(Files.exists(folder.resolve("other.txt")));
    Eventually.await("the witness", () -> state().publishers().get("/chatter").equals(List.of("/witness")));
  }
}
