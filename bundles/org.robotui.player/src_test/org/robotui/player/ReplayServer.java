package org.robotui.player;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.robotui.player.interfaces.Server;
import org.robotui.player.layout.Layouts;
import org.robotui.player.wire.DeviceAddress;
import org.robotui.player.wire.Framing;
import org.robotui.player.wire.MessageType;
import org.robotui.player.wire.PlayerException;
import org.robotui.player.wire.PlayerMessage;

/**
 * Plays the server's side of a recording: says what the real server said, as long as the client says what the recorded
 * client said. The list of devices, for which our client asks first, is answered from the recording as well.
 */
final class ReplayServer implements AutoCloseable {

  private final List<Recording.Turn> turns;
  private final Layouts layouts;
  private final ServerSocket listening;
  private final List<String> differences = new CopyOnWriteArrayList<>();
  private volatile int played;
  private volatile Socket client = new Socket();

  ReplayServer(Recording recording, Layouts layouts, TestThreads threads) throws IOException {
    this.turns = recording.turns();
    this.layouts = layouts;
    this.listening = new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
    threads.newThread(this::play).start();
  }

  int port() {
    return listening.getLocalPort();
  }

  /** How many turns are over. */
  int played() {
    return played;
  }

  /** What the client said otherwise than the recorded one. */
  List<String> differences() {
    return differences;
  }

  private void play() {
    try {
      client = listening.accept();
      InputStream in = client.getInputStream();
      write(Framing.banner("3.1.1-dev"));
      list(Framing.read(in));
      for (Recording.Turn turn : turns) {
        if (!isList(turn.said())) {
          turn(turn, Framing.read(in));
        }
        played++;
      }
    } catch (IOException | PlayerException e) {
      if (played < turns.size()) {
        differences.add("after " + played + " turns: " + e);
      }
    }
  }

  private static boolean isList(PlayerMessage message) {
    return message.device().interfaceCode() == DeviceAddress.SERVER && message.subtype() == 1;
  }

  /** The recorded list, or one of all devices that the recorded client spoke of. */
  private void list(PlayerMessage asked) throws IOException {
    List<Server.Device> spoken = turns.stream().map(this::spokenOf).distinct()
        .filter(device -> device.interfaceCode() != DeviceAddress.SERVER).toList();
    ByteBuffer made = layouts.answer(Server.DEVICES).encode(new Server.DeviceList(spoken));
    ByteBuffer recorded = turns.stream().filter(turn -> isList(turn.said())).flatMap(turn -> turn.followed().stream())
        .filter(ReplayServer::isList).findFirst().map(PlayerMessage::payload).orElse(made);
    write(Framing.bytes(PlayerMessage.of(asked.device(), MessageType.ACK, 1, recorded).withSequence(asked.sequence())));
  }

  private Server.Device spokenOf(Recording.Turn turn) {
    DeviceAddress address = turn.said().device();
    if (address.interfaceCode() == DeviceAddress.SERVER
        && turn.said().subtype() == layouts.message(Server.ACCESS).subtype()) {
      try {
        return layouts.question(Server.ACCESS).decode(turn.said().payload()).device();
      } catch (PlayerException e) {
        throw new AssertionError(e);
      }
    }
    return new Server.Device(address.host(), address.robot(), address.interfaceCode(), address.index());
  }

  private void turn(Recording.Turn turn, PlayerMessage said) throws IOException {
    PlayerMessage expected = turn.said();
    if (said.type() != expected.type() || said.subtype() != expected.subtype()
        || !said.device().id().equals(expected.device().id())
        || !said.payload().equals(expected.payload()) || said.stamp() != expected.stamp()) {
      differences.add("turn " + played + ": " + said + " instead of " + expected);
    }
    for (PlayerMessage each : turn.followed()) {
      boolean numbered =
          each.sequence() == expected.sequence() && each.device().interfaceCode() == DeviceAddress.SERVER;
      write(Framing.bytes(numbered ? each.withSequence(said.sequence()) : each));
    }
  }

  private void write(ByteBuffer frame) throws IOException {
    OutputStream out = client.getOutputStream();
    byte[] bytes = new byte[frame.remaining()];
    frame.get(bytes);
    out.write(bytes);
  }

  @Override
  public void close() throws IOException {
    listening.close();
    client.close();
  }
}
