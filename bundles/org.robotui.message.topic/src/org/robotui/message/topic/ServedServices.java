package org.robotui.message.topic;

import java.time.Duration;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletionStage;
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
import org.robotui.net.call.Outcome;

/**
 * Services that programs of the robot call and that are answered from outside of it. Each is offered as long as its
 * offer is made again and again. One that somebody of the robot offers is left to him. Safe for all threads.
 */
public final class ServedServices implements CallHandler<ServiceOffer, ServiceGrant>, AutoCloseable {
  private static final long LIFETIME = Duration.ofSeconds(ServiceOffer.LIFETIME_SECONDS).toNanos();

  private final ServiceHosting hosting;
  private final TopicSettings settings;
  private final Map<String, Served> served = new HashMap<>();
  private boolean closed;

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

  /** One service, whose responder may be replaced by a later offer. */
  private static final class Served implements ServiceHosting.Host {
    private final String type;
    private final ReplyForm form;
    private Optional<Offer> offer = Optional.empty();
    private volatile ServiceOffer.Responder responder;
    private volatile long until;

    Served(String name, ServiceSchema schema, ServiceOffer asked) {
      this.type = asked.type();
      this.form = new ReplyForm(name, new MessageByNames(schema.response()), schema);
      renew(asked);
    }

    void renew(ServiceOffer asked) {
      responder = asked.responder();
      until = System.nanoTime() + LIFETIME;
    }

    @Override
    public CompletionStage<Outcome<DynamicMessage>> answer(DynamicMessage request, String caller) {
      return responder.answer(new MessageRecord(request), caller).thenApply(form::of);
    }
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
      leave(name);
      throw new CallException(name + " is offered already, by " + other.get() + "; give the bridge another name");
    }
    if (!renewed(name, asked)) {
      adopt(name, asked, CallOutcomes.found(hosting.schema(type)));
    }
    return new ServiceGrant(name, type);
  }

  private synchronized boolean renewed(String name, ServiceOffer asked) {
    Served known = served.get(name);
    if (known == null || !known.type.equals(asked.type())) {
      return false;
    }
    known.renew(asked);
    return true;
  }

  private synchronized void leave(String name) {
    Optional.ofNullable(served.remove(name)).ifPresent(ServedServices::end);
  }

  private synchronized void adopt(String name, ServiceOffer asked, ServiceSchema schema) throws CallException {
    if (closed) {
      throw new CallException("the connection is being closed");
    }
    leave(name);
    Served made = new Served(name, schema, asked);
    try {
      made.offer = Optional.of(hosting.open(name, schema, made));
    } catch (IllegalArgumentException | IllegalStateException e) {
      throw new CallException(name + " cannot be offered: " + e.getMessage(), e);
    }
    served.put(name, made);
  }

  private static void end(Served gone) {
    gone.offer.ifPresent(Offer::close);
  }

  /** Gives up what is not offered any more. To be called at least once a second. */
  public synchronized void tick() {
    long now = System.nanoTime();
    served.values().removeIf(each -> {
      boolean over = now - each.until > 0;
      if (over) {
        end(each);
      }
      return over;
    });
  }

  @Override
  public synchronized void close() {
    closed = true;
    served.values().forEach(ServedServices::end);
    served.clear();
  }
}
