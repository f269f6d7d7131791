/**
 * Bridges: what one robot says, carried to another one by configuration, whatever their frameworks.
 */
@org.osgi.annotation.versioning.Version("1.1.0")
package org.robotui.api.bridge;
