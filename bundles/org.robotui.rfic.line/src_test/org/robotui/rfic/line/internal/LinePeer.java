package org.robotui.rfic.line.internal;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.locks.LockSupport;
import org.robotui.api.Rfic;
import org.robotui.api.RficContext;
import org.robotui.data.ClockKind;
import org.robotui.data.FrameId;
import org.robotui.data.Stamp;
import org.robotui.data.array.Doubles;
import org.robotui.data.command.Motion;
import org.robotui.data.command.VelocityCommand;
import org.robotui.data.navigation.Odometry;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.net.socket.HostPort;
import org.robotui.testkit.rfic.Capability;
import org.robotui.testkit.rfic.GatedPeer;
import org.robotui.testkit.rfic.Sample;

/** A robot that speaks in lines of text, in millimetres and degrees. */
class LinePeer extends GatedPeer {
  private static final Sample POSE = new Sample("pose",
      new Odometry(new FrameId("robby", "odom"), new FrameId("robby", "base"), RigidTransform.planar(1.5, -2, 0),
          Doubles.EMPTY, Vector3.ZERO, Vector3.ZERO, Doubles.EMPTY),
      Optional.of(Stamp.of(1_700_000_000L, 0, ClockKind.ROBOT)));
  private static final long TICK_NANOS = 100_000_000;

  private final Map<Socket, Boolean> callers = new ConcurrentHashMap<>();
  private Optional<ServerSocket> server = Optional.empty();

  @Override
  public Map<Capability, String> lacks() {
    return Map.of(Capability.REGISTRATIONS, "it keeps no list");
  }

  @Override
  public Rfic create(RficContext context) {
    return LineRficType.rfic(context, new LineSettings(new HostPort("127.0.0.1", port()), Duration.ofSeconds(1)));
  }

  @Override
  public void start() throws IOException {
    ServerSocket opened = new ServerSocket(0, 50, InetAddress.getLoopbackAddress());
    server = Optional.of(opened);
    THREADS.newThread(() -> accept(opened)).start();
    gate().open(opened.getLocalPort());
  }

  private void accept(ServerSocket listening) {
    try {
      while (true) {
        Socket caller = listening.accept();
        callers.put(caller, false);
        tell(caller, "hello");
        THREADS.newThread(() -> listen(caller)).start();
        THREADS.newThread(() -> tick(caller)).start();
      }
    } catch (IOException e) {
      // killed
    }
  }

  private void listen(Socket caller) {
    try (caller;
        BufferedReader in =
            new BufferedReader(new InputStreamReader(caller.getInputStream(), StandardCharsets.UTF_8))) {
      for (String line = in.readLine(); line != null; line = in.readLine()) {
        String[] words = line.split(" ");
        switch (words[0]) {
          case "drive" -> hears(VelocityCommand.planar(Double.parseDouble(words[1]) / 1000,
              Math.toRadians(Double.parseDouble(words[2]))));
          default -> callers.put(caller, words[0].equals("want"));
        }
      }
    } catch (IOException e) {
      // the caller is gone
    } finally {
      callers.remove(caller);
    }
  }

  private void tick(Socket caller) {
    while (callers.containsKey(caller)) {
      tell(caller, "tick");
      LockSupport.parkNanos(TICK_NANOS);
    }
  }

  private static void tell(Socket caller, String line) {
    synchronized (caller) {
      try {
        caller.getOutputStream().write((line + "\n").getBytes(StandardCharsets.UTF_8));
      } catch (IOException e) {
        // whoever reads from it notices
      }
    }
  }

  @Override
  public void kill() {
    gate().shut();
    server.ifPresent(LinePeer::quietly);
    callers.keySet().forEach(LinePeer::quietly);
    server = Optional.empty();
  }

  private static void quietly(AutoCloseable each) {
    try {
      each.close();
    } catch (Exception e) {
      // it is over in any case
    }
  }

  @Override
  public void garble() {
    gate().inject("\u0000\u0001 no word\n".getBytes(StandardCharsets.UTF_8));
  }

  @Override
  public List<Sample> samples() {
    return List.of(POSE);
  }

  @Override
  public void say(Sample sample) {
    callers.forEach((caller, wants) -> {
      if (wants) {
        tell(caller, "pose 1700000000 1500 -2000");
      }
    });
  }

  @Override
  public int listeners(Sample sample) {
    return (int) callers.values().stream().filter(wants -> wants).count();
  }

  @Override
  public String motionPort() {
    return "drive";
  }

  @Override
  public Motion<?> motion() {
    return VelocityCommand.planar(0.3, -0.2);
  }

  @Override
  public Set<String> registrations() {
    throw new UnsupportedOperationException("lacking");
  }
}
