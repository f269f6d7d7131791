package org.robotui.yarp.port;

import java.io.IOException;
import java.net.Socket;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.robotui.net.log.PeerText;
import org.robotui.net.socket.DeadlineInput;
import org.robotui.net.socket.HostPort;
import org.robotui.net.socket.Sockets;
import org.robotui.net.thread.Workers;
import org.robotui.yarp.bottle.Bottle;
import org.robotui.yarp.bottle.BottleCodec;
import org.robotui.yarp.bottle.YarpValue;
import org.robotui.yarp.internal.Dialing;
import org.robotui.yarp.wire.MjpegFraming;

/**
 * Pictures of a port by the carrier mjpeg, by which who receives connects. They come on a thread of its own, each as a
 * bottle of one blob, which is a JPEG file. It has one life: where it ends, that is said once.
 */
public final class MjpegStream implements AutoCloseable {
  private static final int BUFFER = 1 << 16;
  private static final Duration REST_OF_PICTURE = Duration.ofSeconds(10);

  private final String name;
  private final HostPort where;
  private final PortReader reader;
  private final PortOptions options;
  private Optional<Socket> socket = Optional.empty(); // guarded by this
  private volatile boolean over;

  /**
   * Begins to connect.
   *
   * @param name of the port that has pictures
   * @param where it listens
   * @param reader takes them
   * @param options of connections
   * @param workers run its thread
   */
  public MjpegStream(String name, HostPort where, PortReader reader, PortOptions options, Workers workers) {
    this.name = name;
    this.where = where;
    this.reader = reader;
    this.options = options;
    workers.start("yarp mjpeg from " + where, this::run);
  }

  private void run() {
    String reason = "it was closed";
    try (Socket connected = Dialing.connect(options.sockets(), where, options.patience())) {
      synchronized (this) {
        socket = Optional.of(connected);
      }
      if (!over) {
        read(connected);
      }
    } catch (IOException e) {
      reason = over ? reason : PeerText.brief(String.valueOf(e.getMessage()));
    } finally {
      over = true;
      reader.ended(name, reason);
    }
  }

  private void read(Socket connected) throws IOException {
    DeadlineInput in = new DeadlineInput(connected, BUFFER);
    in.within(options.patience());
    connected.getOutputStream().write(MjpegFraming.request(where.host()));
    MjpegFraming.readAnswer(in);
    while (!over) {
      in.withoutDeadline();
      String first = MjpegFraming.awaitPart(in);
      in.within(REST_OF_PICTURE);
      byte[] jpeg = MjpegFraming.readPart(first, in);
      Bottle bottle = new Bottle(List.of(YarpValue.Blob.wrap(jpeg)), 0);
      reader.received(new PortArrival(name, bottle, BottleCodec.bytes(bottle), MjpegFraming.stamp(jpeg)));
    }
  }

  /**
   * Whether it has ended.
   *
   * @return false while it connects and is connected
   */
  public boolean over() {
    return over;
  }

  @Override
  public void close() {
    over = true;
    Optional<Socket> open;
    synchronized (this) {
      open = socket;
    }
    open.ifPresent(Sockets::closeQuietly);
  }
}
