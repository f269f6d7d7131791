package org.robotui.ros.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robotui.message.RecordCodec;
import org.robotui.message.ros.std_msgs.StdString;
import org.robotui.message.ros.std_srvs.SetBoolResponse;
import org.robotui.ros.Publisher;
import org.robotui.ros.PublisherOptions;
import org.robotui.ros.RosLog;
import org.robotui.ros.RosNode;
import org.robotui.ros.SubscriberOptions;
import org.robotui.ros.msgs.StandardServices;

/** The stock command line tools, unchanged, with our master and our nodes. */
class StockToolsTest {

  private RosWorld world;
  private RosNode robot;
  private ScheduledExecutorService timer;

  @BeforeEach
  void start() throws Exception {
    RosInstallation.assumeThere();
    world = new RosWorld();
    world.ourMaster();
    robot = world.node("robot");
    Publisher<StdString> publisher =
        robot.publisher("chatter", RecordCodec.of(StdString.class), PublisherOptions.standard());
    robot.serviceServer("~switch", StandardServices.SET_BOOL,
        (request, caller) -> new SetBoolResponse(request.data(), "by us"));
    timer = Executors.newSingleThreadScheduledExecutor();
    timer.scheduleAtFixedRate(() -> publisher.publish(new StdString("tick")), 0, 50, TimeUnit.MILLISECONDS);
    assertTrue(robot.awaitRegistered(Duration.ofSeconds(10)));
  }

  @AfterEach
  void stop() throws Exception {
    if (world != null) {
      timer.shutdownNow();
      world.close();
    }
  }

  private void expect(String output, String... parts) {
    for (String part : parts) {
      assertTrue(output.contains(part), "expected '" + part + "' in:\n" + output);
    }
  }

  @Test
  void rostopicListsTellsAndEchoes() throws Exception {
    expect(world.tool("rostopic", "list", "-v"), "/chatter [std_msgs/String] 1 publisher",
        "/rosout [rosgraph_msgs/Log] 1 subscriber");
    expect(world.tool("rostopic", "type", "/chatter"), "std_msgs/String");
    expect(world.tool("rostopic", "info", "/chatter"), "Type: std_msgs/String", "* /robot (" + robot.uri() + ")");
    expect(world.tool("rostopic", "echo", "-n", "2", "/chatter"), "data: \"tick\"");
  }

  @Test
  void rostopicMeasuresTheRate() throws Exception {
    Peer hz = world.start("rostopic", "hz", "/chatter");
    hz.awaitLine(line -> line.matches("average rate: (19|20|21)\\..*"));
  }

  @Test
  void rostopicPublishesToUs() throws Exception {
    List<String> heard = new CopyOnWriteArrayList<>();
    robot.subscriber("command", RecordCodec.of(StdString.class), SubscriberOptions.standard(),
        (text, reception) -> heard.add(text.data()));
    world.start("rostopic", "pub", "-r", "10", "/command", "std_msgs/String", "data: go");
    Eventually.await("the command", () -> heard.contains("go"));
  }

  @Test
  void rosserviceListsTellsAndCalls() throws Exception {
    expect(world.tool("rosservice", "list"), "/robot/switch");
    expect(world.tool("rosservice", "info", "/robot/switch"), "Node: /robot", "Type: std_srvs/SetBool", "Args: data");
    expect(world.tool("rosservice", "call", "/robot/switch", "data: true"), "success: True", "message: \"by us\"");
  }

  @Test
  void rosparamSetsGetsListsDumpsAndDeletes() throws Exception {
    world.tool("rosparam", "set", "/limits", "{speed: 1.5, gears: [1, 2, R], name: base, enabled: true}");
    expect(world.tool("rosparam", "get", "/limits/speed"), "1.5");
    expect(world.tool("rosparam", "get", "/limits"), "gears:\n- 1\n- 2\n- R\n", "name: base", "enabled: true");
    String list = world.tool("rosparam", "list");
    expect(list, "/limits/speed", "/limits/gears", "/run_id", "/rosdistro", "/rosversion");
    Path dump = world.folder().resolve("dump.yaml");
    world.tool("rosparam", "dump", dump.toString());
    expect(Files.readString(dump), "speed: 1.5", "run_id:");
    world.tool("rosparam", "delete", "/limits/speed");
    assertFalse(world.tool("rosparam", "list").contains("/limits/speed"));
    world.tool("rosparam", "load", dump.toString());
    expect(world.tool("rosparam", "get", "/limits/speed"), "1.5");
  }

  @Test
  void rosnodeListsTellsAndPings() throws Exception {
    expect(world.tool("rosnode", "list"), "/robot", "/rosout");
    expect(world.tool("rosnode", "ping", "-c", "2", "/robot"), "xmlrpc reply from " + robot.uri());
    Peer echo = world.start("rostopic", "echo", "/chatter").awaitLine("tick");
    expect(world.tool("rosnode", "info", "/robot"), "* /chatter [std_msgs/String]", "* /robot/switch",
        "transport: TCPROS",
        "direction: outbound", "Pid: " + ProcessHandle.current().pid());
    echo.kill();
  }

  @Test
  void entriesOfOurLogReachTheLogOfAllNodes() throws Exception {
    Peer echo = world.start("rostopic", "echo", "/rosout_agg");
    try (RosLog log = RosLog.open(robot)) {
      Eventually.await("the entry; rostopic printed " + echo.output(), () -> {
        log.write(RosLog.Level.WARN, "motors", "too hot");
        return echo.output().contains("msg: \"too hot\"") && echo.output().contains("level: 4")
            && echo.output().contains("name: \"/robot\"");
      });
    }
  }

  @Test
  void statisticsOfLinksAreToldAsRospyReadsThem() throws Exception {
    Peer echo = world.start("rostopic", "echo", "/chatter").awaitLine("tick");
    String script =
        "import xmlrpc.client, sys; code, text, (pub, sub, srv) = xmlrpc.client.ServerProxy(sys.argv[1]).getBusStats('/me');"
            + " print(code, [(t, n > 0, [(b > 0, m > 0, up) for i, b, m, up in links]) for t, n, links in pub])";
    expect(world.tool("/usr/bin/python3", "-c", script, robot.uri()), "1 [('/chatter', True, [(True, True, True)])]");
    echo.kill();
  }

  @Test
  void rosnodeCleanupForgetsKilledNodes() throws Exception {
    Peer talker = world.python("talker.py", "doomed", "/doomed_topic");
    expect(world.tool("rosnode", "list"), "/doomed");
    talker.kill();
    Peer cleanup = world.start("rosnode", "cleanup");
    cleanup.tell("y");
    expect(cleanup.finish(), "/doomed");
    String list = world.tool("rosnode", "list");
    assertFalse(list.contains("/doomed"), list);
    assertTrue(list.contains("/robot"), list);
  }

  @Test
  void rosnodeKillEndsOurNodeByTheMaster() throws Exception {
    RosNode victim = world.node("victim");
    victim.publisher("something", RecordCodec.of(StdString.class), PublisherOptions.standard());
    assertTrue(victim.awaitRegistered(Duration.ofSeconds(10)));
    world.tool("rosnode", "kill", "/victim");
    String reason = victim.whenClosed().toCompletableFuture().get(10, TimeUnit.SECONDS);
    assertTrue(reason.contains("shut down by /rosnode"), reason);
  }

  @Test
  void rosbagRecordsUsAndPlaysToUs() throws Exception {
    Path bag = world.folder().resolve("talk.bag");
    Peer record = world.start("rosbag", "record", "-O", bag.toString(), "--duration=3", "/chatter");
    record.finish();
    expect(world.tool("rosbag", "info", bag.toString()), "/chatter", "std_msgs/String");
    Set<String> heard = ConcurrentHashMap.newKeySet();
    robot.subscriber("replay", RecordCodec.of(StdString.class), SubscriberOptions.standard(),
        (text, reception) -> heard.add(text.data()));
    Peer play = world.start("rosbag", "play", "--delay=1", bag.toString(), "/chatter:=/replay");
    Eventually.await(() -> "the recorded message; rosbag printed " + play.output(), () -> heard.equals(Set.of("tick")));
  }

  @Test
  void aNodeOfTheSameNameTakesOver() throws Exception {
    Peer first = world.python("talker.py", "twin", "/one");
    Peer second = world.python("talker.py", "twin", "/two");
    first.awaitLine("shutdown request: new node registered with same name");
    assertEquals(List.of("ready"), second.lines().stream().filter(line -> line.equals("ready")).toList());
    expect(world.tool("rosnode", "info", "/twin"), "/two");
  }
}
