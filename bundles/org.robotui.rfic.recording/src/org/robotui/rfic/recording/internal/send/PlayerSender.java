package org.robotui.rfic.recording.internal.send;

import java.io.IOException;
import java.net.InetAddress;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.ThreadFactory;
import org.robotui.player.layout.Layouts;
import org.robotui.player.server.ServerOptions;
import org.robotui.recording.RecordedChannel;
import org.robotui.recording.RecordedMessage;
import org.robotui.recording.RecordingReader;

/** Serves what was recorded of robots behind Player servers: a server for each robot, one port after the other. */
final class PlayerSender implements FrameworkSender {
  static final String ENCODING = "player";
  private static final String SENDER = "callerid";
  private static final int PORT = 6665;
  private static final int LAST_PORT = 0xffff;
  private static final double NANOS = 1e9;
  private static final Duration PATIENCE = Duration.ofSeconds(2);

  private final Map<Integer, ReplayedRobot> byChannel = new HashMap<>();
  private final List<ReplayedRobot> robots = new ArrayList<>();
  private final InetAddress host;
  private volatile double seconds;

  private PlayerSender(InetAddress host) {
    this.host = host;
  }

  /** Listens where the environment says, else where Player's clients look for a server. */
  static PlayerSender open(RecordingReader recording, List<RecordedChannel> channels, Map<String, String> variables,
      ThreadFactory threads) throws IOException {
    Map<String, List<RecordedChannel>> robots = new TreeMap<>();
    channels.forEach(each -> robots.computeIfAbsent(each.metadata().getOrDefault(SENDER, ""), n -> new ArrayList<>())
        .add(each));
    int port = port(variables);
    PlayerSender sender = new PlayerSender(host(variables));
    sender.seconds = recording.span().map(span -> span.start() / NANOS).orElse(0.0);
    try {
      for (List<RecordedChannel> each : robots.values()) {
        sender.serve(recording, each, threads, port == 0 ? 0 : port + sender.robots.size());
      }
      return sender;
    } catch (IOException | RuntimeException e) {
      sender.close();
      throw e;
    }
  }

  private void serve(RecordingReader recording, List<RecordedChannel> channels, ThreadFactory threads, int port)
      throws IOException {
    ServerOptions usual = ServerOptions.loopback(threads, port, () -> seconds);
    ServerOptions options = new ServerOptions(threads, host, port, usual.version(), usual.key(), usual.clock(),
        usual.maxClients(), usual.maxQueued(), usual.messageTime());
    ReplayedRobot robot;
    try {
      robot = ReplayedRobot.open(Layouts.standard(), options);
    } catch (IOException e) {
      throw new IOException("no Player server can listen at " + host.getHostAddress() + ":" + port + " ("
          + e.getMessage() + "); PLAYER_HOST names an address of this machine, PLAYER_PORT a port (0 for a free one)",
          e);
    }
    robots.add(robot);
    robot.add(recording, channels);
    channels.forEach(each -> byChannel.put(each.id(), robot));
  }

  private static InetAddress host(Map<String, String> variables) throws IOException {
    Optional<String> given = given(variables, "PLAYER_HOST");
    return given.isPresent() ? InetAddress.getByName(given.get()) : InetAddress.getLoopbackAddress();
  }

  private static int port(Map<String, String> variables) throws IOException {
    String written = given(variables, "PLAYER_PORT").orElse(Integer.toString(PORT));
    if (!written.matches("\\d{1,5}") || Integer.parseInt(written) > LAST_PORT) {
      throw new IOException("PLAYER_PORT is '" + written + "'; write a port from 1 to 65535, or 0 for a free one");
    }
    return Integer.parseInt(written);
  }

  private static Optional<String> given(Map<String, String> variables, String name) {
    return Optional.ofNullable(variables.get(name)).map(String::strip).filter(value -> !value.isEmpty());
  }

  @Override
  public List<String> places() {
    return robots.stream().map(each -> "Player server at " + host.getHostAddress() + ":" + each.port() + " with "
        + String.join(", ", each.devices())).toList();
  }

  @Override
  public void send(RecordedMessage message) {
    byChannel.get(message.channel().id()).publish(message);
  }

  /** Player has no message for that, but answers have it as their stamp. */
  @Override
  public void clock(long nanos) {
    seconds = nanos / NANOS;
  }

  @Override
  public boolean isHeard() {
    return robots.stream().allMatch(ReplayedRobot::isHeard);
  }

  @Override
  public void finish() {
    try {
      for (ReplayedRobot each : robots) {
        each.awaitSent(PATIENCE);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  @Override
  public void close() {
    robots.forEach(ReplayedRobot::close);
  }
}
