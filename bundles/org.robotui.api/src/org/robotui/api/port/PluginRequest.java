package org.robotui.api.port;

/**
 * What a plugin of a robot's control shall do, or the drives of its joints.
 *
 * @param plugin its name; empty where all drives are meant
 * @param verb what
 * @param words for {@link Verb#COMMAND} alone: words that the plugin understands
 */
public record PluginRequest(String plugin, Verb verb, String words) {
  /** What can be asked of a plugin, and of drives. */
  public enum Verb {
    /** Begin to be called. */
    START,
    /** End to be called. */
    STOP,
    /** Be loaded again from its library, which may have changed; it must not run. */
    RELOAD,
    /** Hear words. */
    COMMAND,
    /** The drives that are disabled: be enabled. */
    ENABLE_DRIVES,
    /** All drives: be disabled. No plugin may lead a joint. */
    DISABLE_DRIVES,
    /** The drives in fault: be brought back. */
    RECOVER_DRIVES
  }
}
