/**
 * How a bundle brings a kind of display into scenes: a {@link org.robotui.gl.display.DisplayType} as an OSGi service.
 * Scenes take what comes and goes while they run.
 */
@org.osgi.annotation.versioning.Version("1.3.0")
package org.robotui.gl.display;
