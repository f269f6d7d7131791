package org.robotui.yarp.port;

import java.io.IOException;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.time.Duration;
import java.util.concurrent.atomic.AtomicBoolean;
import org.robotui.net.call.Outcome;
import org.robotui.net.log.PeerText;
import org.robotui.net.socket.DeadlineInput;
import org.robotui.net.socket.HostPort;
import org.robotui.net.socket.Sockets;
import org.robotui.yarp.bottle.Bottle;
import org.robotui.yarp.bottle.BottleCodec;
import org.robotui.yarp.internal.Dialing;
import org.robotui.yarp.wire.YarpCarrier;
import org.robotui.yarp.wire.YarpFraming;
import org.robotui.yarp.wire.YarpMessage;

/**
 * A connection to a port that is asked, by tcp. One question at a time; who asks waits for those before. Where an
 * answer does not come, the connection is closed, as a late one would be taken for that of the next question.
 */
public final class PortCall implements AutoCloseable {
  private static final int BUFFER = 1 << 13;

  private final HostPort where;
  private final Socket socket;
  private final DeadlineInput in;
  private final AtomicBoolean closed = new AtomicBoolean();

  private PortCall(HostPort where, Socket socket, PortOptions options, String name) throws IOException {
    this.where = where;
    this.socket = socket;
    this.in = new DeadlineInput(socket, BUFFER);
    in.within(options.patience());
    socket.getOutputStream().write(YarpFraming.bytes(new YarpFraming.Header(YarpCarrier.TCP, name)));
    YarpFraming.readMark(in);
  }

  /**
   * Connects, which blocks.
   *
   * @param where the port listens
   * @param name of who asks
   * @param options of connections
   * @return to be closed
   * @throws IOException where the port is not reached, or is none
   */
  public static PortCall connect(HostPort where, String name, PortOptions options) throws IOException {
    Socket socket = Dialing.connect(options.sockets(), where, options.patience());
    try {
      return new PortCall(where, socket, options, name);
    } catch (IOException | RuntimeException e) {
      Sockets.closeQuietly(socket);
      throw e;
    }
  }

  /**
   * Asks, which blocks.
   *
   * @param question what is asked
   * @param patience how long the answer may take
   * @return the answer; an empty one where the port takes the question without a word
   */
  public synchronized Outcome<Bottle> ask(Bottle question, Duration patience) {
    if (closed.get()) {
      return new Outcome.Failed<>("the connection to " + where + " is closed");
    }
    try {
      in.within(patience);
      socket.getOutputStream().write(YarpFraming.bytes(YarpMessage.of(BottleCodec.bytes(question))));
      return new Outcome.Done<>(answer());
    } catch (SocketTimeoutException e) {
      close();
      return new Outcome.TimedOut<>(where + " did not answer '" + PeerText.brief(question.toString()) + "' in time",
          patience);
    } catch (IOException e) {
      close();
      return new Outcome.Failed<>(where + ": " + PeerText.brief(String.valueOf(e.getMessage())));
    }
  }

  /** The answer comes without any length before it, and then the acknowledgement. */
  private Bottle answer() throws IOException {
    int first = YarpFraming.int32(in);
    if (YarpFraming.isMark(first)) {
      YarpFraming.readMark(first, in);
      return Bottle.of();
    }
    Bottle answer = BottleCodec.read(first, in);
    YarpFraming.readMark(in);
    return answer;
  }

  /**
   * Whether it can still be asked.
   *
   * @return false once an answer did not come
   */
  public boolean isOpen() {
    return !closed.get();
  }

  /** Ends the connection. */
  @Override
  public void close() {
    if (closed.compareAndSet(false, true)) {
      Sockets.closeQuietly(socket);
    }
  }
}
