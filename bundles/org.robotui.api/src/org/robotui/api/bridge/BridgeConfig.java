package org.robotui.api.bridge;

import java.nio.file.Path;
import org.robotui.api.config.Settings;

/**
 * A bridge as it is written. Its settings are those of {@link BridgeWords#SCHEMA}.
 *
 * @param file the configuration, as it was loaded
 * @param line where it is written, from 1
 * @param name unique within the file
 * @param from where values come from
 * @param to where they go
 * @param settings what is done to them on the way
 */
public record BridgeConfig(Path file, int line, String name, BridgeEnd from, BridgeEnd to, Settings settings) {}
