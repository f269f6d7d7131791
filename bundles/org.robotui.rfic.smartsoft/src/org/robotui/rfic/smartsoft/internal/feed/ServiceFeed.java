package org.robotui.rfic.smartsoft.internal.feed;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.robotui.api.port.RawDefinition;
import org.robotui.api.port.RawMessage;
import org.robotui.api.port.RawOrigin;
import org.robotui.data.Stamp;
import org.robotui.data.array.Bytes;
import org.robotui.data.record.DynamicRecord;
import org.robotui.message.DynamicMessage;
import org.robotui.message.MessageException;
import org.robotui.message.data.MessageRecord;
import org.robotui.smartsoft.client.PatternClient;
import org.robotui.smartsoft.naming.NamedService;
import org.robotui.smartsoft.naming.ServiceAddress;
import org.robotui.smartsoft.naming.ServiceName;
import org.robotui.smartsoft.object.CommType;

/**
 * A service whose objects come by themselves. It is connected to only while somebody wants one of its ports, and again
 * where the connection was lost. Objects come on a reading thread; {@link #tick} is for the thread that follows.
 */
final class ServiceFeed implements AutoCloseable {
  /** What recordings of ROS 2 call this encoding, which is that of SmartSoft behind four bytes. */
  private static final String ENCODING = "cdr";
  private static final String DEFINITION = "ros2msg";
  private static final int ENCAPSULATION = 4;
  private static final long AGAIN_NANOS = Duration.ofSeconds(1).toNanos();
  /**
   * Where objects have their time; of what is measured on the move, that of the measurement before that of the base.
   */
  private static final List<String> STAMPS = List.of("timeStamp", "time", "timestamp",
      "laser_scan_pose.laser_scan.time", "irScan.timeStamp", "usScan.timeStamp", "base_state.timeStamp");

  /** Connects to the service, and lets its objects come. */
  interface Opening {
    PatternClient open(ServiceAddress address, Consumer<ByteBuffer> taking) throws IOException;
  }

  private final SmartShared shared;
  private final ServiceName name;
  private final CommType type;
  private final Opening opening;
  private final Consumer<DynamicMessage> seeing;
  private final List<SmartOutlet<?>> outlets;
  private volatile Optional<ServiceAddress> address = Optional.empty();
  private Optional<ServiceAddress> connectedTo = Optional.empty(); // guarded by this, as the following
  private Optional<PatternClient> client = Optional.empty();
  private boolean closed;
  private long triedAt = System.nanoTime() - AGAIN_NANOS;

  /** Seeing takes each object, whoever wants it, before the ports do. */
  ServiceFeed(SmartShared shared, ServiceName name, CommType type, Opening opening, Consumer<DynamicMessage> seeing,
      List<SmartOutlet<?>> outlets) {
    this.shared = shared;
    this.name = name;
    this.type = type;
    this.opening = opening;
    this.seeing = seeing;
    this.outlets = outlets;
  }

  ServiceName name() {
    return name;
  }

  CommType type() {
    return type;
  }

  boolean wanted() {
    return outlets.stream().anyMatch(SmartOutlet::wanted);
  }

  boolean placedAndWanted() {
    return outlets.stream().anyMatch(SmartOutlet::placedAndWanted);
  }

  synchronized boolean isAlive() {
    return client.isPresent() && client.get().over().isEmpty();
  }

  /** Where the service is now, or that it is nowhere. */
  void at(Optional<NamedService> entry) {
    address = entry.map(NamedService::address);
  }

  /** Acts on what is needed now; may block while it connects. */
  void tick(boolean needed) {
    boolean here = address.isPresent();
    if (settle(needed && here)) {
      connect(address.get());
    } else if (needed && !here) {
      outlets.forEach(outlet -> outlet.failed("the naming service has no " + name.path() + " any more; start "
          + name.component() + " again"));
    }
  }

  /** Ends what is over or needed no more; answers whether to connect now. */
  private synchronized boolean settle(boolean needed) {
    Optional<String> over = client.flatMap(PatternClient::over);
    over.ifPresent(reason -> outlets.forEach(outlet -> outlet.lost(reason)));
    if (client.isPresent() && (over.isPresent() || !needed || !connectedTo.equals(address))) {
      client.get().close();
      client = Optional.empty();
    }
    boolean due = System.nanoTime() - triedAt >= AGAIN_NANOS;
    return needed && !closed && client.isEmpty() && due;
  }

  private void connect(ServiceAddress to) {
    triedAt = System.nanoTime();
    try {
      PatternClient made = opening.open(to, this::take);
      if (!keep(made, to)) {
        made.close();
      }
      outlets.forEach(outlet -> outlet.failed(""));
    } catch (IOException e) {
      outlets.forEach(outlet -> outlet.failed(name.path() + ": " + e.getMessage()
          + "; it is entered at the naming service, so its component may have been killed"));
    }
  }

  private synchronized boolean keep(PatternClient made, ServiceAddress to) {
    if (!closed) {
      client = Optional.of(made);
      connectedTo = Optional.of(to);
    }
    return !closed;
  }

  private void take(ByteBuffer object) {
    long now = System.nanoTime();
    shared.pulse().heard(now);
    try {
      DynamicMessage read = type.read(object);
      Optional<Stamp> stamp =
          STAMPS.stream().map(field -> shared.stamp(read, field)).flatMap(Optional::stream).findFirst();
      seeing.accept(read);
      outlets.forEach(outlet -> outlet.take(read, stamp, now, () -> raw(object)));
    } catch (MessageException | IllegalArgumentException e) {
      outlets.forEach(outlet -> outlet.lost(name.path() + ": " + e.getMessage()));
    }
  }

  private RawMessage raw(ByteBuffer object) {
    ByteBuffer bytes = ByteBuffer.allocate(ENCAPSULATION + object.remaining());
    bytes.put(1, (byte) (object.order() == ByteOrder.LITTLE_ENDIAN ? 1 : 0));
    bytes.position(ENCAPSULATION).put(object.duplicate()).flip();
    return new RawMessage(type.schema().definition().type(), ENCODING, Bytes.wrap(bytes), this::read,
        new RawOrigin(name.path(), name.component(), false, () -> Optional.of(definition())));
  }

  private RawDefinition definition() {
    return new RawDefinition(type.schema().definition().type(), DEFINITION,
        Bytes.of(type.schema().info().definition().getBytes(StandardCharsets.UTF_8)));
  }

  private Optional<DynamicRecord> read(Bytes bytes) {
    ByteBuffer all = bytes.buffer(ByteOrder.LITTLE_ENDIAN);
    ByteOrder order = all.get(all.position() + 1) == 1 ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN;
    ByteBuffer object = all.slice(all.position() + ENCAPSULATION, all.remaining() - ENCAPSULATION).order(order);
    try {
      return Optional.of(new MessageRecord(type.read(object)));
    } catch (MessageException e) {
      return Optional.empty();
    }
  }

  /** Says goodbye without waiting; {@link #close} waits. */
  synchronized void finish() {
    closed = true;
    client.ifPresent(PatternClient::finish);
  }

  @Override
  public void close() {
    finish();
    outlets.forEach(SmartOutlet::close);
    Optional<PatternClient> last;
    synchronized (this) {
      last = client;
      client = Optional.empty();
    }
    last.ifPresent(PatternClient::close);
  }
}
