package org.robotui.player.internal.server;

import java.io.IOException;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.util.Optional;
import org.robotui.net.socket.DeadlineInput;
import org.robotui.net.socket.Sockets;
import org.robotui.player.layout.Layouts;
import org.robotui.player.server.Answer;
import org.robotui.player.server.ServerOptions;
import org.robotui.player.wire.DeviceAddress;
import org.robotui.player.wire.DeviceId;
import org.robotui.player.wire.Framing;
import org.robotui.player.wire.MessageType;
import org.robotui.player.wire.PlayerException;
import org.robotui.player.wire.PlayerMessage;

/** One client of a server. */
final class ClientSession {

  private static final int BUFFER = 1 << 16;
  private static final int END_OF_ROUND = 1;
  private static final int OVERFLOW = 2;
  private static final ByteBuffer NOTHING = ByteBuffer.allocate(0).asReadOnlyBuffer();

  private final Socket socket;
  private final Registry registry;
  private final ServerOptions options;
  private final ServerRequests own;
  private final SendQueue out;
  private final int host;
  private final int robot;

  ClientSession(Socket socket, Layouts layouts, Registry registry, ServerOptions options) {
    this.socket = socket;
    this.registry = registry;
    this.options = options;
    this.out = new SendQueue(options.maxQueued());
    this.own = new ServerRequests(layouts, registry, this, out, options.key());
    this.host = DeviceAddress.host(socket.getLocalAddress().getAddress());
    this.robot = socket.getLocalPort();
  }

  /** A device's address as this client sees it. */
  DeviceAddress address(DeviceId id) {
    return id.at(host, robot);
  }

  void data(DeviceId id, int subtype, ByteBuffer payload, double stamp) {
    out.data(new PlayerMessage(address(id), MessageType.DATA, subtype, stamp, 0, payload));
  }

  /** Reads until the client goes, which is always an exception. */
  void receive() throws IOException, PlayerException {
    DeadlineInput in = new DeadlineInput(socket, BUFFER);
    while (true) {
      in.nextMessage(options.messageTime());
      PlayerMessage message = Framing.read(in);
      switch (message.type()) {
        case REQUEST -> request(message);
        case COMMAND -> command(message);
        default -> throw new PlayerException("a client sends " + message);
      }
    }
  }

  /** As real servers do: whoever commands a device need not have opened it. */
  private void command(PlayerMessage command) {
    if (registry.has(command.device().id())) {
      registry.command(command);
    }
  }

  private void request(PlayerMessage request) throws PlayerException {
    if (request.device().interfaceCode() != DeviceAddress.SERVER) {
      ofDevice(request);
    } else if (own.isFetch(request)) {
      PlayerMessage mark = PlayerMessage.empty(address(DeviceId.SERVER), MessageType.SYNC, END_OF_ROUND)
          .withStamp(options.clock().getAsDouble());
      keepsUp(out.fetch(reply(request, MessageType.ACK, NOTHING, request.sequence()), mark));
    } else {
      say(request, own.answer(request), request.sequence());
    }
  }

  /**
   * As real servers do: nothing from a device that is not there, a refusal from one that is not open, and no number.
   */
  private void ofDevice(PlayerMessage request) throws PlayerException {
    if (registry.has(request.device().id())) {
      say(request, registry.isOpen(request.device().id(), this) ? registry.request(request) : Answer.refused(), 0);
    }
  }

  private void say(PlayerMessage request, Answer answer, long sequence) throws PlayerException {
    if (answer instanceof Answer.Ack ack) {
      keepsUp(out.answer(reply(request, MessageType.ACK, ack.payload(), sequence)));
    } else if (answer instanceof Answer.Nack nack) {
      keepsUp(out.answer(reply(request, MessageType.NACK, nack.payload(), sequence)));
    }
  }

  private static void keepsUp(boolean taken) throws PlayerException {
    if (!taken) {
      throw new PlayerException("the client asks, but does not read the answers");
    }
  }

  private PlayerMessage reply(PlayerMessage request, MessageType type, ByteBuffer payload, long sequence) {
    return new PlayerMessage(address(request.device().id()), type, request.subtype(), options.clock().getAsDouble(),
        sequence, payload);
  }

  /** Greets, and sends until closed. */
  void send() throws IOException, InterruptedException {
    write(Framing.banner(options.version()));
    for (Optional<PlayerMessage> next = out.take(); next.isPresent(); next = out.take()) {
      long dropped = out.takeDropped();
      if (dropped > 0) {
        ByteBuffer count = ByteBuffer.allocate(Integer.BYTES).putInt((int) Math.min(Integer.MAX_VALUE, dropped)).flip();
        write(Framing.bytes(PlayerMessage.of(address(DeviceId.SERVER), MessageType.SYNC, OVERFLOW, count)));
      }
      write(Framing.bytes(next.get()));
    }
  }

  private void write(ByteBuffer frame) throws IOException {
    byte[] bytes = new byte[frame.remaining()];
    frame.get(bytes);
    socket.getOutputStream().write(bytes);
  }

  /** Waits until all that the client is to be told was written. */
  boolean awaitSent(long deadlineNanos) throws InterruptedException {
    return out.awaitSent(deadlineNanos);
  }

  /** Lets everything go that the client had open. */
  void close() {
    out.close();
    Sockets.closeQuietly(socket);
    registry.closeAll(this);
  }
}
