package org.robotui.rfic.player.internal.call;

import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.Supplier;
import org.robotui.api.port.CallException;
import org.robotui.api.port.CallHandler;
import org.robotui.api.port.Offer;
import org.robotui.api.port.ServiceReply;
import org.robotui.api.port.ServiceRequest;
import org.robotui.data.record.MapRecord;
import org.robotui.net.call.Outcome;
import org.robotui.player.client.DeviceState;
import org.robotui.player.layout.Layouts;
import org.robotui.player.layout.MessageLayout;
import org.robotui.player.layout.PlayerRecord;
import org.robotui.player.layout.StructLayout;
import org.robotui.player.wire.MessageType;
import org.robotui.rfic.player.internal.convert.RecordView;
import org.robotui.rfic.player.internal.device.DeviceFeed;
import org.robotui.rfic.player.internal.link.Devices;

/**
 * Asks and tells devices. A device is opened for it, and stays open for a while, as closing it may undo what it was
 * told.
 */
public final class PlayerCalls implements CallHandler<ServiceRequest, ServiceReply> {
  private static final long LOOK_MILLIS = 5;

  private final Devices devices;
  private final Layouts layouts;

  public PlayerCalls(Devices devices, Layouts layouts) {
    this.devices = devices;
    this.layouts = layouts;
  }

  @Override
  public ServiceReply handle(Invocation<ServiceRequest> invocation) throws CallException, InterruptedException {
    ServiceRequest asked = invocation.request();
    Callable callable = Callable.find(asked.service(), devices, layouts).orElseThrow(
        () -> new CallException("no device has '" + asked.service() + "'; calls are named as in gripper:0/open"));
    DeviceFeed feed = callable.feed();
    try (Offer hold = feed.hold()) {
      feed.linger();
      awaitOpen(feed, invocation.deadlineNanos());
      return callable.message().type() == MessageType.COMMAND
          ? command(feed, callable.message(), asked.arguments())
          : request(feed, callable.message(), asked.arguments(), invocation.deadlineNanos());
    }
  }

  private static void awaitOpen(DeviceFeed feed, long deadlineNanos) throws CallException, InterruptedException {
    while (!feed.open()) {
      if (feed.device().state() instanceof DeviceState.Refused refused) {
        throw new CallException(refused.reason());
      }
      if (System.nanoTime() - deadlineNanos > 0) {
        throw new CallException(feed.name() + " was not opened in time; see the state of the link");
      }
      Thread.sleep(LOOK_MILLIS);
    }
  }

  private static ServiceReply command(DeviceFeed feed, MessageLayout message, Map<String, Object> arguments)
      throws CallException {
    PlayerRecord body = body(feed, message, arguments);
    if (!said(feed, message, () -> feed.device().command(message, body))) {
      throw new CallException(feed.name() + " is not open any more");
    }
    return new ServiceReply(new MapRecord("sent", Map.of()));
  }

  private static ServiceReply request(DeviceFeed feed, MessageLayout message, Map<String, Object> arguments,
      long deadlineNanos)
      throws CallException, InterruptedException {
    PlayerRecord body = body(feed, message, arguments);
    CompletableFuture<Outcome<PlayerRecord>> future = said(feed, message, () -> feed.device().request(message, body));
    try {
      Outcome<PlayerRecord> outcome = future.get(Math.max(1, deadlineNanos - System.nanoTime()), TimeUnit.NANOSECONDS);
      PlayerRecord answer = outcome.toOptional().orElseThrow(() -> new CallException(outcome.reason()));
      return new ServiceReply(new RecordView(answer.layout().name(), answer));
    } catch (TimeoutException e) {
      throw new CallException(message.name() + " of " + feed.name() + " was not answered in time", e);
    } catch (ExecutionException e) {
      throw new CallException(message.name() + " of " + feed.name() + " was lost: " + e.getCause(), e);
    }
  }

  private static PlayerRecord body(DeviceFeed feed, MessageLayout message, Map<String, Object> arguments)
      throws CallException {
    Optional<StructLayout> struct = message.payload();
    if (struct.isEmpty() && !arguments.isEmpty()) {
      throw new CallException(message.name() + " of " + feed.name() + " takes no fields");
    }
    return struct.isEmpty() ? PlayerRecord.empty()
        : said(feed, message, () -> PlayerRecord.of(struct.get(), arguments));
  }

  private static <T> T said(DeviceFeed feed, MessageLayout message, Supplier<T> saying) throws CallException {
    try {
      return saying.get();
    } catch (IllegalArgumentException | ClassCastException e) {
      throw new CallException(message.name() + " of " + feed.name() + " is not asked like this: " + e.getMessage(), e);
    }
  }
}
