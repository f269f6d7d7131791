package org.robotui.smartsoft.server;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicLong;
import org.robotui.message.CdrReader;
import org.robotui.message.MessageException;
import org.robotui.smartsoft.internal.PatternData;
import org.robotui.smartsoft.internal.ServedClient;
import org.robotui.smartsoft.internal.ServiceDoor;
import org.robotui.smartsoft.naming.ServiceAddress;
import org.robotui.smartsoft.wire.SmartCommand;
import org.robotui.smartsoft.wire.SmartFrame;

/** A server of push. A client that takes less than comes is given the newest. */
public final class PushServer implements PatternServer {

  private final Duration period;
  private final ServiceDoor door;
  private final Map<ServedClient, Subscription> subscriptions = new ConcurrentHashMap<>();
  private volatile boolean active = true;

  private record Subscription(int every, int number, AtomicLong count) {}

  /**
   * Listens at once.
   *
   * @param options where
   * @param period between updates, which clients of timed servers are told; zero where there is none
   * @throws IOException where the port cannot be had
   */
  public PushServer(SmartServerOptions options, Duration period) throws IOException {
    this.period = period;
    this.door = new ServiceDoor(options, new FromClients());
  }

  @Override
  public ServiceAddress address() {
    return door.address();
  }

  /**
   * How many have subscribed.
   *
   * @return clients
   */
  public int subscribers() {
    return subscriptions.size();
  }

  /**
   * Updates all who have subscribed and whose turn it is.
   *
   * @param object little endian
   */
  public void put(ByteBuffer object) {
    subscriptions.forEach((client, subscription) -> {
      if (subscription.count().getAndIncrement() % subscription.every() == 0) {
        client.replace("update", SmartFrame.of(SmartCommand.UPDATE, PatternData.of().i32(subscription.number()).end(),
            object));
      }
    });
  }

  /**
   * Says whether updates come from now on, as timed servers do.
   *
   * @param now whether they come
   */
  public void activate(boolean now) {
    active = now;
    subscriptions.keySet().forEach(client -> client
        .send(SmartFrame.of(SmartCommand.ACTIVATION_STATE, PatternData.of().i32(now ? 1 : 0).end())));
  }

  private final class FromClients implements ServiceDoor.Pattern {
    @Override
    public void said(SmartCommand command, SmartFrame frame, ServedClient client) throws MessageException {
      switch (command) {
        case SUBSCRIBE -> {
          CdrReader said = frame.reader();
          int every = Math.max(1, said.int32("every"));
          client.send(SmartFrame.of(SmartCommand.ACK_SUBSCRIBE, PatternData.of().i32(active ? 1 : 0).end()));
          subscriptions.put(client, new Subscription(every, said.int32("subscription"), new AtomicLong()));
        }
        case UNSUBSCRIBE -> subscriptions.remove(client);
        case GET_SERVER_INFO -> client.send(SmartFrame.of(SmartCommand.SERVER_INFO,
            PatternData.of().i64(period.toMillis()).i32(active ? 1 : 0).end()));
        default -> {}
      }
    }

    @Override
    public void left(ServedClient client) {
      subscriptions.remove(client);
    }
  }

  @Override
  public void close() {
    door.close();
  }
}
