package org.robotui.yarp.internal;

import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.robotui.net.thread.Workers;
import org.robotui.yarp.wire.YarpCarrier;
import org.robotui.yarp.wire.YarpFraming;

/** Who says something to a port by datagrams. A sender that comes again takes the place of what it was. */
final class DatagramInputs implements Closeable {
  private static final int MOST = 64;
  private static final int ADDRESS = 4;
  private static final int SHORT = 0xffff;

  private final Served served;
  private final Workers workers;
  private final Map<String, DatagramInput> inputs = new ConcurrentHashMap<>();
  private volatile boolean closed;

  DatagramInputs(Served served, Workers workers) {
    this.served = served;
    this.workers = workers;
  }

  /** Answers to the header of a sender, whose connection is of no use after that. */
  void open(YarpFraming.Header header, Socket socket, InputStream in) throws IOException {
    if (inputs.size() >= MOST) {
      throw new IOException("there are " + MOST + " senders of datagrams already");
    }
    boolean shared = header.carrier() == YarpCarrier.MCAST;
    DatagramInput input = shared ? DatagramInput.group(group(in), socket.getLocalAddress())
        : DatagramInput.alone(socket.getLocalAddress(), socket.getInetAddress());
    if (!shared) {
      socket.getOutputStream().write(YarpFraming.mark(input.port()));
    }
    served.opened(header.name());
    DatagramInput before = inputs.put(header.name(), input);
    if (before != null) {
      before.close();
    }
    if (closed) {
      input.close();
    }
    workers.start("yarp " + served.name() + " by " + header.carrier().word() + " from " + header.name(),
        () -> receive(header.name(), input));
  }

  private static InetSocketAddress group(InputStream in) throws IOException {
    byte[] said = in.readNBytes(YarpFraming.GROUP);
    if (said.length < YarpFraming.GROUP) {
      throw new IOException("the connection ended before it named a group");
    }
    ByteBuffer bytes = ByteBuffer.wrap(said);
    byte[] address = new byte[ADDRESS];
    bytes.get(address);
    return new InetSocketAddress(InetAddress.getByAddress(address), bytes.getShort() & SHORT);
  }

  private void receive(String name, DatagramInput input) {
    String reason = "it was closed";
    try (input) {
      reason = input.receive(message -> {
        if (message.isData()) {
          served.data(name, message);
        }
      }, lost -> served.lost(name, lost));
    } finally {
      inputs.remove(name, input);
      served.ended(name, reason);
    }
  }

  /** Ends what a sender says; false where it says nothing by datagrams. */
  boolean end(String name) {
    DatagramInput input = inputs.get(name);
    if (input != null) {
      input.close();
    }
    return input != null;
  }

  @Override
  public void close() {
    closed = true;
    inputs.values().forEach(DatagramInput::close);
  }
}
