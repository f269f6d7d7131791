package org.robotui.message.topic;

import java.util.Optional;
import java.util.concurrent.CompletionStage;
import org.robotui.api.port.Offer;
import org.robotui.message.DynamicMessage;
import org.robotui.message.SchemaLookup;
import org.robotui.message.ServiceSchema;
import org.robotui.net.call.Outcome;

/** How a framework offers services of any type to the programs of its robot. May ask the robot, and wait for it. */
public interface ServiceHosting {

  /** Answers calls of one service. */
  @FunctionalInterface
  interface Host {
    /**
     * Answers a call; must not block.
     *
     * @param request what is asked
     * @param caller who asks
     * @return completes with the response, or with why there is none; never completes exceptionally
     */
    CompletionStage<Outcome<DynamicMessage>> answer(DynamicMessage request, String caller);
  }

  /**
   * The definition of a type of services.
   *
   * @param type its name of two parts
   * @return the definition, or why it is not known here
   */
  SchemaLookup<ServiceSchema> schema(String type);

  /**
   * Who offers a service already.
   *
   * @param service its whole name
   * @return the name of another node, or none where nobody does
   */
  Optional<String> provider(String service);

  /**
   * Offers a service.
   *
   * @param service its whole name
   * @param schema its type
   * @param host answers calls
   * @return offers it no longer when closed
   */
  Offer open(String service, ServiceSchema schema, Host host);
}
