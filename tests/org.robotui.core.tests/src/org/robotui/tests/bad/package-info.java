/**
 * A bundle whose view and whose robot interface misbehave as their settings say. Tests pack it at run time and install
 * it, so that it is a bundle like any other: with a name and a class loader of its own.
 */
package org.robotui.tests.bad;
