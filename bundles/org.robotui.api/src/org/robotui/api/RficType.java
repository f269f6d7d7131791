package org.robotui.api;

import org.robotui.api.config.Settings;

/** A type of robotics framework interface component: a client of one framework. */
public interface RficType extends ComponentType {
  /**
   * Creates an instance; must neither block nor start anything. Called on a core worker.
   *
   * @param context what core gives to the instance
   * @param settings checked against the schema
   * @return a new instance, owned by core
   */
  Rfic create(RficContext context, Settings settings);
}
