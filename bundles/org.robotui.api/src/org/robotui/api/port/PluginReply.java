package org.robotui.api.port;

/**
 * What became of a request to a plugin.
 *
 * @param done whether it was done
 * @param text why not, or what the plugin says
 */
public record PluginReply(boolean done, String text) {}
