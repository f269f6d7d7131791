package org.robotui.message.topic;

import java.util.Optional;
import java.util.Set;
import org.robotui.api.port.ActionOffer;
import org.robotui.api.port.ActionReply;
import org.robotui.api.port.CallException;
import org.robotui.api.port.CallHandler;
import org.robotui.api.port.CallOutcome;
import org.robotui.api.port.Caller.Call;
import org.robotui.api.port.Caller.Progress;
import org.robotui.api.port.ServiceGrant;
import org.robotui.data.record.DynamicRecord;
import org.robotui.message.DynamicMessage;
import org.robotui.message.Generation;
import org.robotui.message.data.MessageByNames;
import org.robotui.message.data.MessageRecord;
import org.robotui.message.topic.internal.Renewals;

/**
 * Actions that programs of the robot send goals to and that are carried out outside of it. Each is offered as long as
 * its offer is made again and again. One that somebody of the robot serves is left to him. Safe for all threads.
 *
 * @param <T> what the framework has to know of a type
 */
public final class ServedActions<T> implements CallHandler<ActionOffer, ServiceGrant>, AutoCloseable {
  private final ActionHosting<T> hosting;
  private final TopicSettings settings;
  private final Renewals<ActionOffer, ActionHosting.Hosted> served = new Renewals<>(ActionHosting.Hosted::close);

  /**
   * Offers nothing yet.
   *
   * @param hosting how the framework offers actions
   * @param settings where names begin
   */
  public ServedActions(ActionHosting<T> hosting, TopicSettings settings) {
    this.hosting = hosting;
    this.settings = settings;
  }

  @Override
  public ServiceGrant handle(Invocation<ActionOffer> invocation) throws CallException {
    ActionOffer asked = invocation.request();
    String name = settings.topic(asked.action());
    Optional<String> other = hosting.provider(name);
    if (other.isPresent()) {
      served.leave(name);
      throw new CallException(name + " is served already, by " + other.get() + "; give the bridge another name");
    }
    ActionHosting.Form<T> form = CallOutcomes.found(hosting.form(Generation.plainName(asked.type())));
    if (!served.renewed(name, form.name(), asked)) {
      served.adopt(name, form.name(), asked, held -> hosting.open(name, form,
          (goal, client, heard) -> begin(held.asked(), goal, client, new Telling(form, heard))));
    }
    return new ServiceGrant(name, form.name());
  }

  private static Runnable begin(ActionOffer offer, DynamicMessage goal, String client, Telling telling) {
    Call<ActionReply> call = offer.worker().begin(new MessageRecord(goal), client, telling);
    call.outcome().thenAccept(telling::ended);
    return call::cancel;
  }

  /** Makes messages of what is told. What does not fit the type is left out: the goal goes on as it does. */
  private record Telling(MessageByNames results, MessageByNames feedbacks, ActionHosting.Heard heard)
      implements Progress {
    Telling(ActionHosting.Form<?> form, ActionHosting.Heard heard) {
      this(new MessageByNames(form.result()), new MessageByNames(form.feedback()), heard);
    }

    @Override
    public void at(double fraction, String message) {
      if (ActionCalls.isAtWork(message)) {
        heard.begun();
      }
    }

    @Override
    public void feedback(DynamicRecord record) {
      heard.begun();
      made(feedbacks, record).ifPresent(heard::feedback);
    }

    private static Optional<DynamicMessage> made(MessageByNames messages, DynamicRecord record) {
      try {
        return Optional.of(messages.of(record));
      } catch (IllegalArgumentException e) {
        return Optional.empty();
      }
    }

    void ended(CallOutcome<ActionReply> outcome) {
      switch (outcome) {
        case CallOutcome.Replied<ActionReply> replied -> heard.end(replied.reply().end(), replied.reply().text(),
            replied.reply().result().flatMap(record -> made(results, record)));
        case CallOutcome.Failed<ActionReply> failed -> heard.end(ActionReply.End.REJECTED, failed.reason(),
            Optional.empty());
        case CallOutcome.TimedOut<ActionReply> late -> heard.end(ActionReply.End.ABORTED, "did not end in time",
            Optional.empty());
        case CallOutcome.Cancelled<ActionReply> cancelled -> heard.end(ActionReply.End.PREEMPTED, "was ended",
            Optional.empty());
      }
    }
  }

  /** Gives up what is not offered any more, and tells how goals stand. To be called at least five times a second. */
  public void tick() {
    served.tick(ActionHosting.Hosted::tick);
  }

  /**
   * What is offered now.
   *
   * @return the whole names of the actions
   */
  public Set<String> names() {
    return served.names();
  }

  @Override
  public void close() {
    served.close();
  }
}
