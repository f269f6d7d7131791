/**
 * What an application (workbench, headless) sees of the core.
 */
@org.osgi.annotation.versioning.Version("1.12.0")
package org.robotui.api.host;
