package org.robotui.rfic.ros.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;

import java.io.Reader;
import java.io.Writer;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Properties;
import java.util.Set;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robotui.message.RecordCodec;
import org.robotui.message.ros.std_msgs.StdFloat64;
import org.robotui.net.thread.Workers;
import org.robotui.rfic.ros.internal.graph.SharedCleanup;
import org.robotui.ros.GraphName;
import org.robotui.ros.NodeOptions;
import org.robotui.ros.PublisherOptions;
import org.robotui.ros.RosEnvironment;
import org.robotui.ros.RosNode;
import org.robotui.ros.XmlRpcValue;
import org.robotui.ros.internal.xmlrpc.MethodCall;
import org.robotui.ros.internal.xmlrpc.XmlRpcLimits;
import org.robotui.ros.internal.xmlrpc.XmlRpcServer;
import org.robotui.ros.master.MasterOptions;
import org.robotui.ros.master.RosMaster;
import org.robotui.testkit.FakeRficContext;

/** With a master that is not there when the tidying begins. */
class RepeatedCleanupTest {
  private static final ThreadFactory DAEMONS = Thread.ofPlatform().daemon().factory();
  private static final InetAddress LOOPBACK = InetAddress.getLoopbackAddress();

  private final FakeRficContext context = new FakeRficContext();
  private final BlockingQueue<String> asked = new LinkedBlockingQueue<>();
  private Path note;
  private String left;

  /** What a node writes down, as if its process had ended. */
  @BeforeEach
  void leaveANote() throws Exception {
    Process ended = new ProcessBuilder("true").start();
    assertEquals(0, ended.waitFor());
    Properties written = new Properties();
    Set<Path> others = notes(context.stateFolder()); // of nodes of this process whose masters hung at their end
    try (RosMaster master = RosMaster.open(MasterOptions.standard(DAEMONS));
        RosNode node = RosNode.open(RosEnvironment.of(URI.create(master.uri().toString())), GraphName.of("killed"),
            NodeOptions.standard(DAEMONS).withRecords(context.stateFolder()))) {
      node.publisher("/value", RecordCodec.of(StdFloat64.class), PublisherOptions.standard());
      node.awaitRegistered(Duration.ofSeconds(10));
      Set<Path> mine = notes(context.stateFolder());
      mine.removeAll(others);
      assertEquals(1, mine.size(), mine.toString());
      note = mine.iterator().next();
      try (Reader in = Files.newBufferedReader(note)) {
        written.load(in);
      }
    }
    left = written.getProperty("uri");
    written.setProperty("pid", Long.toString(ended.pid()));
    try (ServerSocket free = new ServerSocket(0, 1, LOOPBACK)) {
      written.setProperty("master", "http://127.0.0.1:" + free.getLocalPort() + "/");
    }
    try (Writer out = Files.newBufferedWriter(note)) {
      written.store(out, "");
    }
  }

  private static Set<Path> notes(Path folder) throws Exception {
    if (!Files.isDirectory(folder)) {
      return new HashSet<>();
    }
    try (var files = Files.list(folder)) {
      return files.filter(f -> f.toString().endsWith(".rosnode")).collect(Collectors.toCollection(HashSet::new));
    }
  }

  @AfterEach
  void removeTheNote() throws Exception {
    Files.deleteIfExists(note);
  }

  private int masterPort() throws Exception {
    Properties written = new Properties();
    try (Reader in = Files.newBufferedReader(note)) {
      written.load(in);
    }
    return URI.create(written.getProperty("master")).getPort();
  }

  private XmlRpcValue answer(MethodCall call) {
    asked.add(call.method());
    XmlRpcValue publishers =
        XmlRpcValue.of(XmlRpcValue.of(XmlRpcValue.of("/value"), XmlRpcValue.ofTexts(List.of("/killed"))));
    XmlRpcValue result = switch (call.method()) {
      case "lookupNode" -> XmlRpcValue.of(left);
      case "getSystemState" -> XmlRpcValue.of(publishers, XmlRpcValue.ofTexts(List.of()),
          XmlRpcValue.ofTexts(List.of()));
      default -> XmlRpcValue.of(1);
    };
    return XmlRpcValue.of(XmlRpcValue.of(1), XmlRpcValue.of(""), result);
  }

  @Test
  void whatIsLeftAtAMasterThatComesLaterIsRemovedThen() throws Exception {
    int port = masterPort();
    RepeatedCleanup tidying = new RepeatedCleanup(context, new SharedCleanup(), Duration.ofMillis(20));
    try (ServerSocket notYet = new ServerSocket(port, 10, LOOPBACK)) {
      notYet.setSoTimeout(10_000);
      tidying.start();
      notYet.accept().close();
    }
    try (XmlRpcServer master =
        new XmlRpcServer(LOOPBACK, port, XmlRpcLimits.standard(), new Workers(DAEMONS), "late master")) {
      master.start(this::answer);
      Map<String, Integer> seen = new java.util.HashMap<>();
      while (!seen.containsKey("unregisterPublisher")) {
        String method = asked.poll(10, TimeUnit.SECONDS);
        assertNotNull(method, "asked only for " + seen);
        seen.merge(method, 1, Integer::sum);
      }
    }
    tidying.close();
    assertEquals(List.of(), context.alive());
  }

  @Test
  void aTeamRemovesTogetherWhatIsLeft() throws Exception {
    SharedCleanup shared = new SharedCleanup();
    List<RepeatedCleanup> team =
        Stream.generate(() -> new RepeatedCleanup(context, shared, Duration.ofMinutes(1))).limit(20).toList();
    int port = masterPort();
    try (XmlRpcServer master =
        new XmlRpcServer(LOOPBACK, port, XmlRpcLimits.standard(), new Workers(DAEMONS), "master")) {
      master.start(call -> {
        LockSupport.parkNanos(TimeUnit.MILLISECONDS.toNanos(100)); // so that all come before the first is done
        return answer(call);
      });
      team.forEach(RepeatedCleanup::start);
      RosRficCase.await(() -> context.alive().isEmpty());
    }
    assertEquals(1, asked.stream().filter("unregisterPublisher"::equals).count(), asked.toString());
  }

  @Test
  void waitingForAMasterEndsWithTheRobotInterface() {
    RepeatedCleanup tidying = new RepeatedCleanup(context, new SharedCleanup(), Duration.ofMinutes(1));
    tidying.start();
    tidying.close();
    assertEquals(List.of(), context.alive());
  }
}
