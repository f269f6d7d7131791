package org.robotui.message.topic;

import java.util.Optional;
import org.robotui.api.port.ActionReply;
import org.robotui.message.DynamicMessage;
import org.robotui.message.MessageSchema;
import org.robotui.message.SchemaLookup;

/**
 * How a framework offers actions of any type to the programs of its robot. May ask the robot, and wait for it.
 *
 * @param <T> what the framework has to know of a type
 */
public interface ActionHosting<T> {

  /**
   * A type of actions.
   *
   * @param name the robot's name of it
   * @param result what comes of a goal
   * @param feedback what is told on the way
   * @param known what the framework has to know
   * @param <T> its kind
   */
  record Form<T>(String name, MessageSchema result, MessageSchema feedback, T known) {}

  /** Carries out the goals of one action. */
  @FunctionalInterface
  interface Host {
    /**
     * Begins with a goal; must not block.
     *
     * @param goal what is asked for
     * @param client who asks; empty where that is not known
     * @param heard is told how far it gets
     * @return asks for its end; does not wait
     */
    Runnable begin(DynamicMessage goal, String client, Heard heard);
  }

  /** Tells the client of a goal. Any thread may use it. */
  interface Heard {
    /** The work on it has begun. */
    void begun();

    /**
     * How it gets on.
     *
     * @param feedback of the type of the action
     */
    void feedback(DynamicMessage feedback);

    /**
     * It has ended. Only the first end counts.
     *
     * @param end how
     * @param text for users
     * @param result of the type of the action, where there is one
     */
    void end(ActionReply.End end, String text, Optional<DynamicMessage> result);
  }

  /** An action that is offered. */
  interface Hosted extends AutoCloseable {
    /** To be called at least five times a second. */
    default void tick() {}

    /** Offers it no longer; goals are asked to end. */
    @Override
    void close();
  }

  /**
   * The definition of a type of actions.
   *
   * @param type its name of two parts, in this framework or another one
   * @return the definition, or why it is not known here
   */
  SchemaLookup<Form<T>> form(String type);

  /**
   * Who offers an action already.
   *
   * @param action its whole name
   * @return the name of another node, or none where nobody does
   */
  Optional<String> provider(String action);

  /**
   * Offers an action.
   *
   * @param action its whole name
   * @param form its type
   * @param host carries out goals
   * @return offers it no longer when closed
   */
  Hosted open(String action, Form<T> form, Host host);
}
