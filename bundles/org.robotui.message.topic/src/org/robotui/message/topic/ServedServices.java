package org.robotui.message.topic;

import java.util.Optional;
import org.robotui.api.port.CallException;
import org.robotui.api.port.CallHandler;
import org.robotui.api.port.CallOutcome;
import org.robotui.api.port.Offer;
import org.robotui.api.port.ServiceGrant;
import org.robotui.api.port.ServiceOffer;
import org.robotui.api.port.ServiceReply;
import org.robotui.message.DynamicMessage;
import org.robotui.message.Generation;
import org.robotui.message.ServiceSchema;
import org.robotui.message.data.MessageByNames;
import org.robotui.message.data.MessageRecord;
import org.robotui.message.topic.internal.Renewals;
import org.robotui.net.call.Outcome;

/**
 * Services that programs of the robot call and that are answered from outside of it. Each is offered as long as its
 * offer is made again and again. One that somebody of the robot offers is left to him. Safe for all threads.
 */
public final class ServedServices implements CallHandler<ServiceOffer, ServiceGrant>, AutoCloseable {
  private final ServiceHosting hosting;
  private final TopicSettings settings;
  private final Renewals<ServiceOffer, Offer> served = new Renewals<>(Offer::close);

  /**
   * Offers nothing yet.
   *
   * @param hosting how the framework offers services
   * @param settings where names begin
   */
  public ServedServices(ServiceHosting hosting, TopicSettings settings) {
    this.hosting = hosting;
    this.settings = settings;
  }

  /** Makes messages of replies. */
  private record ReplyForm(String name, MessageByNames messages, ServiceSchema schema) {
    Outcome<DynamicMessage> of(CallOutcome<ServiceReply> outcome) {
      return switch (outcome) {
        case CallOutcome.Replied<ServiceReply> replied -> message(replied.reply());
        case CallOutcome.Failed<ServiceReply> failed -> new Outcome.Failed<>(failed.reason());
        case CallOutcome.TimedOut<ServiceReply> late -> new Outcome.Failed<>(name + " was not answered in time");
        case CallOutcome.Cancelled<ServiceReply> cancelled -> new Outcome.Failed<>(
            "the call of " + name + " was ended");
      };
    }

    private Outcome<DynamicMessage> message(ServiceReply reply) {
      try {
        return new Outcome.Done<>(messages.of(reply.value()));
      } catch (IllegalArgumentException e) {
        return new Outcome.Failed<>("the answer does not fit " + schema.type() + ": " + e.getMessage());
      }
    }
  }

  @Override
  public ServiceGrant handle(Invocation<ServiceOffer> invocation) throws CallException {
    ServiceOffer asked = invocation.request();
    String type = Generation.plainName(asked.type());
    String name = settings.topic(asked.service());
    Optional<String> other = hosting.provider(name);
    if (other.isPresent()) {
      served.leave(name);
      throw new CallException(name + " is offered already, by " + other.get() + "; give the bridge another name");
    }
    if (!served.renewed(name, type, asked)) {
      ServiceSchema schema = CallOutcomes.found(hosting.schema(type));
      ReplyForm form = new ReplyForm(name, new MessageByNames(schema.response()), schema);
      served.adopt(name, type, asked, held -> hosting.open(name, schema, (request, caller) -> held.asked().responder()
          .answer(new MessageRecord(request), caller).thenApply(form::of)));
    }
    return new ServiceGrant(name, type);
  }

  /** Gives up what is not offered any more. To be called at least once a second. */
  public void tick() {
    served.tick(offer -> {});
  }

  @Override
  public void close() {
    served.close();
  }
}
