package org.robotui.api.host;

import java.nio.file.Path;

/**
 * A window that a configuration asks for. Where it asks for several, they lie side by side in this order.
 *
 * @param file the configuration, as it was loaded
 * @param ruic the RUIC that the window begins with
 * @param weight its share of the width, relative to the others; positive
 */
public record WindowConfig(Path file, String ruic, double weight) {}
