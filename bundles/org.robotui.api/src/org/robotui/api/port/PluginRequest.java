package org.robotui.api.port;

/**
 * What a plugin of a robot's control shall do, or the drives of its joints.
 *
 * @param plugin its name; empty where all drives are meant, the first one where several are
 * @param verb what
 * @param words for {@link Verb#COMMAND}: words that the plugin understands; for {@link Verb#SWITCH_TOGETHER}: names of
 * plugins, each with 1 (start) or 0 (stop) behind it, with spaces between
 */
public record PluginRequest(String plugin, Verb verb, String words) {
  /** What can be asked of a plugin, and of drives. */
  public enum Verb {
    /** Begin to be called. */
    START,
    /** End to be called. */
    STOP,
    /** Several plugins: begin and end to be called, all in the same cycle of the control, or none of them. */
    SWITCH_TOGETHER,
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
