package org.robotui.api.port;

/**
 * What a plugin of a robot's control shall do.
 *
 * @param plugin its name
 * @param verb what
 * @param words for {@link Verb#COMMAND} alone: words that the plugin understands
 */
public record PluginRequest(String plugin, Verb verb, String words) {
  /** What can be asked of a plugin. */
  public enum Verb {
    /** Begin to be called. */
    START,
    /** End to be called. */
    STOP,
    /** Be loaded again from its library, which may have changed; it must not run. */
    RELOAD,
    /** Hear words. */
    COMMAND
  }
}
