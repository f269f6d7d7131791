package org.robotui.api.port;

/**
 * A port for requests with a reply: services, actions, plug-in verbs.
 *
 * @param <Q> the type of requests
 * @param <R> the type of replies
 * @param name unique within the component
 * @param request what is asked
 * @param reply what is answered
 * @param arity how many connections a view takes
 * @param help a sentence for users
 * @param guarded true where calls command the robot: they need the lease, are refused while stopped, and a stop cancels
 * them
 */
public record CallPort<Q, R>(
    String name, Class<Q> request, Class<R> reply, Arity arity, String help, boolean guarded) implements Port {
  /**
   * A port whose calls need no lease.
   *
   * @param name unique within the component
   * @param request what is asked
   * @param reply what is answered
   * @param arity how many connections a view takes
   * @param help a sentence for users
   */
  public CallPort(String name, Class<Q> request, Class<R> reply, Arity arity, String help) {
    this(name, request, reply, arity, help, false);
  }

  @Override
  public PortKind kind() {
    return PortKind.CALL;
  }

  @Override
  public String typeName() {
    return request.getSimpleName() + " -> " + reply.getSimpleName();
  }
}
