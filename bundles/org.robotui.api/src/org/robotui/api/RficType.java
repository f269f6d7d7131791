package org.robotui.api;

import java.util.Optional;
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

  /**
   * The files that it opens without a configuration of a user: they are given to an instance by one setting, and all
   * others have their usual values. An instance whose file is wrong reports a link that has failed, with the reason.
   *
   * @return always the same; none where its robots are no files
   */
  default Optional<FileKind> files() {
    return Optional.empty();
  }
}
