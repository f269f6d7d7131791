package org.robotui.rfic.carmen.internal.call;

import java.io.IOException;
import java.time.Duration;
import java.util.Map;
import org.robotui.api.port.CallException;
import org.robotui.api.port.CallHandler;
import org.robotui.api.port.ServiceReply;
import org.robotui.api.port.ServiceRequest;
import org.robotui.carmen.message.FieldName;
import org.robotui.carmen.message.IpcRecord;
import org.robotui.carmen.message.IpcForm;
import org.robotui.carmen.message.IpcRecordMaker;
import org.robotui.carmen.module.IpcAnswer;
import org.robotui.carmen.module.IpcModule;
import org.robotui.carmen.module.MessageSender;
import org.robotui.data.record.MapRecord;
import org.robotui.net.call.Outcome;
import org.robotui.rfic.carmen.internal.convert.CarmenRecord;
import org.robotui.rfic.carmen.internal.feed.Direction;
import org.robotui.rfic.carmen.internal.feed.Feeds;

/** Asks and tells programs by the names of messages. What is not given is 0 or empty; time and host are ours. */
public final class CarmenCalls implements CallHandler<ServiceRequest, ServiceReply> {
  private static final double MILLIS = 1e3;

  private final IpcModule module;
  private final Feeds feeds;

  public CarmenCalls(IpcModule module, Feeds feeds) {
    this.module = module;
    this.feeds = feeds;
  }

  /** Whether a message is for calls. */
  static boolean takes(String message) {
    Direction direction = Direction.of(message);
    return direction == Direction.QUESTION || direction == Direction.TO_ROBOT;
  }

  @Override
  public ServiceReply handle(Invocation<ServiceRequest> invocation) throws CallException {
    ServiceRequest asked = invocation.request();
    IpcForm form = feeds.find(asked.service()).filter(known -> takes(known.name()))
        .orElseThrow(() -> new CallException("no program takes '" + asked.service() + "' from calls"));
    if (!feeds.isHandled(form.name())) {
      throw new CallException("no program that runs takes " + form.name());
    }
    try {
      IpcRecord record = record(form, asked.arguments());
      MessageSender sender = module.sender(form);
      if (Direction.of(form.name()) == Direction.TO_ROBOT) {
        return told(sender, record);
      }
      long left = Math.max(1, invocation.deadlineNanos() - System.nanoTime());
      Outcome<IpcAnswer> outcome = sender.query(record, Duration.ofNanos(left));
      IpcAnswer answer = outcome.toOptional().orElseThrow(() -> new CallException(outcome.reason()));
      return new ServiceReply(new CarmenRecord(answer.form().name(), answer.record()));
    } catch (IOException e) {
      throw new CallException(e.getMessage(), e);
    }
  }

  private static ServiceReply told(MessageSender sender, IpcRecord record) throws CallException {
    if (!sender.publish(record)) {
      throw new CallException("the central takes nothing more");
    }
    return new ServiceReply(new MapRecord("sent", Map.of()));
  }

  private IpcRecord record(IpcForm form, Map<String, Object> arguments) throws CallException {
    IpcRecordMaker made = form.make();
    for (FieldName field : form.fields()) {
      Object given = arguments.get(field.name());
      try {
        set(made, field, given);
      } catch (IllegalArgumentException e) {
        throw new CallException(form.name() + " is not asked like this: " + e.getMessage(), e);
      }
    }
    for (String name : arguments.keySet()) {
      if (form.fields().stream().noneMatch(field -> field.name().equals(name))) {
        throw new CallException(form.name() + " has no field " + name);
      }
    }
    return made.build();
  }

  private void set(IpcRecordMaker made, FieldName field, Object given) {
    switch (given) {
      case null -> ours(made, field.name());
      case Number number -> made.number(field.name(), number.doubleValue());
      case Boolean flag -> made.number(field.name(), flag ? 1 : 0);
      case String text -> made.text(field.name(), text);
      case Map<?, ?> members -> made.struct(field.name(), field.members().stream()
          .mapToDouble(each -> members.get(each.name()) instanceof Number n ? n.doubleValue() : 0).toArray());
      default -> throw new IllegalArgumentException(field.name() + " cannot be set by a call");
    }
  }

  private void ours(IpcRecordMaker made, String field) {
    if (field.equals("timestamp")) {
      made.number(field, System.currentTimeMillis() / MILLIS);
    } else if (field.equals("host")) {
      made.text(field, module.name());
    }
  }
}
