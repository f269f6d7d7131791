package org.robotui.api.port;

import java.util.concurrent.CompletionStage;
import org.robotui.data.record.DynamicRecord;

/**
 * A service for the programs of a robot that is answered from outside of it, such as by another robot. It is offered
 * for {@link #LIFETIME_SECONDS}, and longer where it is offered again until then.
 *
 * @param service the robot's name of the service
 * @param type the robot's name of its type, such as {@code std_srvs/SetBool}
 * @param responder answers calls
 */
public record ServiceOffer(String service, String type, Responder responder) {
  /** How long an offer holds. */
  public static final int LIFETIME_SECONDS = 6;

  /** Answers calls. Safe for all threads. */
  @FunctionalInterface
  public interface Responder {
    /**
     * Answers a call. Must not block.
     *
     * @param request the fields of the request
     * @param caller who asks, as the robot calls it
     * @return completes with the reply, or with why there is none; never completes exceptionally
     */
    CompletionStage<CallOutcome<ServiceReply>> answer(DynamicRecord request, String caller);
  }
}
