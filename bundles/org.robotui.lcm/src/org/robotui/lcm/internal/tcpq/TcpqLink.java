package org.robotui.lcm.internal.tcpq;

import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.OutputStream;
import java.net.Socket;
import java.net.SocketException;
import java.nio.ByteBuffer;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.robotui.lcm.LcmMessage;
import org.robotui.lcm.LcmOptions;
import org.robotui.lcm.internal.client.Inlet;
import org.robotui.lcm.internal.client.Link;
import org.robotui.net.log.PeerText;
import org.robotui.net.socket.DeadlineInput;

/** A connection to a server of messages. */
final class TcpqLink implements Link {

  private static final int BUFFER = 1 << 16;

  private final Socket socket;
  private final String server;
  private final DeadlineInput timed;
  private final DataInputStream in;
  private final OutputStream out;
  private final int maxMessageBytes;
  private final Inlet inlet;

  private TcpqLink(Socket socket, String server, int maxMessageBytes, Inlet inlet) throws IOException {
    this.socket = socket;
    this.server = server;
    this.timed = new DeadlineInput(socket, BUFFER);
    this.in = new DataInputStream(timed);
    this.out = socket.getOutputStream();
    this.maxMessageBytes = maxMessageBytes;
    this.inlet = inlet;
  }

  /** Greets the server, which must answer in time. */
  static TcpqLink greet(Socket socket, String server, LcmOptions options, Inlet inlet) throws IOException {
    TcpqLink link = new TcpqLink(socket, server, options.maxMessageBytes(), inlet);
    link.timed.within(options.connectTime());
    link.send(Frames.greeting(Frames.CLIENT));
    Frames.expectGreeting(link.in, Frames.SERVER);
    link.timed.withoutDeadline();
    return link;
  }

  @Override
  public String where() {
    return "the server " + server;
  }

  @Override
  public String receive() throws IOException {
    while (true) {
      Frames.Frame frame = read();
      if (!(frame instanceof Frames.Message message)) {
        throw new IOException("the server " + server + " sends requests, as a client does");
      }
      if (inlet.wants(message.channel())) {
        long utime = TimeUnit.MILLISECONDS.toMicros(System.currentTimeMillis());
        inlet.deliver(
            new LcmMessage(message.channel(), ByteBuffer.wrap(message.data()), server, System.nanoTime(), utime));
      }
    }
  }

  private Frames.Frame read() throws IOException {
    try {
      return Frames.read(in, maxMessageBytes);
    } catch (EOFException e) {
      throw new IOException("the server " + server + " closed the connection"
          + Optional.ofNullable(e.getMessage()).map(m -> ": " + m).orElse(""), e);
    } catch (SocketException e) {
      throw broken(e);
    } catch (IOException e) {
      IOException broken = broken(e);
      inlet.counters().damaged(broken.getMessage()); // the link is soon made again, and would look as if nothing had
                                                     // been lost
      throw broken;
    }
  }

  private IOException broken(IOException e) {
    return new IOException("the server " + server + ": " + PeerText.brief(String.valueOf(e.getMessage())), e);
  }

  @Override
  public void publish(byte[] channel, ByteBuffer data) throws IOException {
    send(Frames.message(channel, data));
  }

  @Override
  public void subscribed(String channels) throws IOException {
    send(Frames.request(Frames.SUBSCRIBE, channels));
  }

  @Override
  public void unsubscribed(String channels) throws IOException {
    send(Frames.request(Frames.UNSUBSCRIBE, channels));
  }

  private void send(ByteBuffer frame) throws IOException {
    synchronized (out) {
      out.write(frame.array(), 0, frame.limit());
    }
  }

  @Override
  public void close() throws IOException {
    socket.close();
  }
}
