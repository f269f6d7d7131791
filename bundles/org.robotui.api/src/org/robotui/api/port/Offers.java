package org.robotui.api.port;

import org.robotui.data.Data;

/**
 * What a robot interface offers. Ports may be added and withdrawn at any time, from any thread; core matches again.
 * Offering a name twice for one kind is an {@link IllegalStateException}.
 */
public interface Offers {
  /**
   * Offers data.
   *
   * @param <T> the type of the data
   * @param port the port
   * @param demand is told when the first consumer comes and the last goes
   * @return where to publish
   */
  <T extends Data> Publication<T> stream(StreamPort<T> port, Demand demand);

  /**
   * Offers to take commands.
   *
   * @param <T> the type of the commands
   * @param port the port
   * @param sink takes them
   * @return withdraws the offer when closed
   */
  <T extends Data> Offer command(CommandPort<T> port, CommandSink<T> sink);

  /**
   * Offers to answer requests.
   *
   * @param <Q> the type of requests
   * @param <R> the type of replies
   * @param port the port
   * @param handler answers them
   * @return withdraws the offer when closed
   */
  <Q, R> Offer call(CallPort<Q, R> port, CallHandler<Q, R> handler);

  /**
   * Offers to be browsed.
   *
   * @param port the port
   * @param browser answers
   * @return withdraws the offer when closed
   */
  Offer browse(BrowsePort port, Browser browser);
}
