/**
 * Commands and who may give them.
 */
@org.osgi.annotation.versioning.Version("1.1.0")
package org.robotui.api.command;
