package org.robotui.rfic.lcm.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.api.Rfic;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.CommandSink;
import org.robotui.api.port.CommandSink.Sent;
import org.robotui.data.ClockKind;
import org.robotui.data.Data;
import org.robotui.data.command.VelocityCommand;
import org.robotui.data.sensor.Battery;
import org.robotui.guard.Guards;
import org.robotui.lcm.log.EventLogIndex;
import org.robotui.lcm.log.EventLogWriter;
import org.robotui.lcm.tcpq.TcpqServer;
import org.robotui.lcm.tcpq.TcpqServerOptions;
import org.robotui.lcm.type.LcmType;
import org.robotui.lcm.type.TypeFolder;
import org.robotui.rfic.lcm.internal.convert.RecordFiller;
import org.robotui.testkit.FakeRficContext;

/** The stock tools of LCM, which play and write logs with the C client, as the robot. */
class StockToolsTest {
  private static final int MESSAGES = 200;
  private static final long START = 1_700_000_000_000_000L;

  private final FakeRficContext context = new FakeRficContext();
  private final List<Process> processes = new ArrayList<>();

  @TempDir
  private Path folder;
  private Path log;
  private TcpqServer server;
  private String url;
  private Rfic rfic;

  @BeforeEach
  void writeLog() throws Exception {
    log = folder.resolve("robot.lcmlog");
    var types = TypeFolder.read(List.of(Written.types()));
    LcmType battery = types.type("robotui.battery_t").orElseThrow();
    try (EventLogWriter writer = EventLogWriter.create(log)) {
      for (int i = 0; i < MESSAGES; i++) {
        long utime = START + i * 10_000L;
        writer.write(utime, "BATTERY",
            battery.encode(new RecordFiller(types).fill(battery, Map.of("utime", utime, "voltage", 10 + i * 0.01))));
      }
    }
  }

  private void openServer() throws IOException {
    try (ServerSocket free = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      url = "tcpq://127.0.0.1:" + free.getLocalPort();
    }
    server = TcpqServer.open(TcpqServerOptions.loopback(Thread.ofPlatform().daemon().factory(),
        Integer.parseInt(url.substring(url.lastIndexOf(':') + 1))));
  }

  private void open(String at) {
    rfic = LcmSessions.rfic(context,
        Written.right(Written.settings(at, Written.types().toString(), Map.of("BATTERY", "battery"),
            Map.of("VELOCITY", Written.map("as", "velocity", "type", "robotui.velocity_t")))),
        new Guards());
    rfic.start();
    await(() -> context.streams.containsKey("BATTERY") && context.sinks.containsKey("VELOCITY"));
    context.demand("BATTERY", true);
  }

  @AfterEach
  void closeAll() throws Exception {
    if (rfic != null) { // a test that is skipped opens none
      rfic.close();
    }
    await(() -> context.alive().isEmpty());
    for (Process process : processes) {
      process.destroyForcibly().waitFor();
    }
    if (server != null) {
      server.close();
    }
  }

  private static void await(BooleanSupplier condition) {
    long end = System.nanoTime() + Duration.ofSeconds(60).toNanos();
    while (!condition.getAsBoolean()) {
      assertTrue(System.nanoTime() < end, "waited in vain");
      LockSupport.parkNanos(5_000_000);
    }
  }

  /** Starts a stock tool; the test is skipped where it is not installed. */
  private Process tool(String... command) throws IOException {
    boolean there =
        List.of("/usr/bin/", "/usr/local/bin/").stream().anyMatch(bin -> Files.isExecutable(Path.of(bin + command[0])));
    Assumptions.assumeTrue(there, command[0] + " is not installed: needs the Debian package liblcm-bin");
    Process process = new ProcessBuilder(command).directory(folder.toFile()).redirectErrorStream(true)
        .redirectOutput(folder.resolve("out").toFile()).start();
    processes.add(process);
    return process;
  }

  private int batteries() {
    return context.published.get("BATTERY").size();
  }

  private FakeRficContext.Published newest() {
    return context.published.get("BATTERY").getLast();
  }

  @Test
  void whatTheStockPlayerSendsBecomesDataAlsoAfterItWasKilled() throws Exception {
    openServer();
    open(url);
    Process first = tool("lcm-logplayer", "--lcm-url=" + url, log.toString());
    await(() -> batteries() > 10 && context.links.peekLast() instanceof LinkState.Connected);
    first.destroyForcibly().waitFor();
    int before = batteries();
    tool("lcm-logplayer", "--lcm-url=" + url, log.toString());
    // What the first one had sent may have been on its way when it was killed: counting says too early that all came.
    await(() -> newest().stamp().filter(s -> s.nanos() == (START + (MESSAGES - 1) * 10_000L) * 1000).isPresent());
    assertTrue(batteries() >= before + MESSAGES, batteries() + " after " + before);
    FakeRficContext.Published last = newest();
    assertEquals(10 + (MESSAGES - 1) * 0.01, assertInstanceOf(Battery.class, last.value()).voltage(), 1e-9);
    assertEquals((START + (MESSAGES - 1) * 10_000L) * 1000, last.stamp().orElseThrow().nanos());
  }

  @Test
  @SuppressWarnings("unchecked")
  void commandsReachTheStockLogger() throws Exception {
    openServer();
    Path written = folder.resolve("commands.lcmlog");
    Process logger = tool("lcm-logger", "--lcm-url=" + url, "--flush-interval=50", written.toString());
    open(url);
    CommandSink<Data> sink = (CommandSink<Data>) context.sinks.get("VELOCITY");
    await(() -> {
      boolean out = sink.send(VelocityCommand.planar(0.5, 0)) instanceof Sent.Out;
      return out && count(written) >= 3;
    });
    logger.destroy();
    assertTrue(logger.waitFor(20, TimeUnit.SECONDS));
    assertEquals(0, EventLogIndex.of(written).damagedBytes());
  }

  private static int count(Path file) {
    try {
      return EventLogIndex.of(file).channels().getOrDefault("VELOCITY", 0);
    } catch (IOException e) {
      return 0;
    }
  }

  @Test
  @SuppressWarnings("unchecked")
  void aLogIsPlayedInItsOwnTimeAndTakesNoCommands() {
    open("file://" + log + "?speed=4");
    await(() -> batteries() > 20);
    FakeRficContext.Published first = context.published.get("BATTERY").getLast();
    assertEquals(ClockKind.SIMULATED, first.stamp().orElseThrow().clock());
    assertTrue(context.simulated.peekLast() >= START * 1000, "time is that of the log");
    assertInstanceOf(Sent.Refused.class,
        ((CommandSink<Data>) context.sinks.get("VELOCITY")).send(VelocityCommand.ZERO));
    await(() -> context.links.peekLast() instanceof LinkState.Degraded d && d.reason().contains("end"));
  }
}
